// SPDX-License-Identifier: MIT
// The least and the greatest of a few doubles for inner loops. Engines compile WebAssembly's scalar
// minimum and maximum with a branch; if any value may be the least, every other branch is
// mispredicted. The vector instructions need no branch.
#pragma once

#include <algorithm>

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace remesher {

#if defined(__wasm_simd128__)
inline double least(double a, double b) {
  return wasm_f64x2_extract_lane(wasm_f64x2_pmin(wasm_f64x2_splat(a), wasm_f64x2_splat(b)), 0);
}
inline double greatest(double a, double b) {
  return wasm_f64x2_extract_lane(wasm_f64x2_pmax(wasm_f64x2_splat(a), wasm_f64x2_splat(b)), 0);
}
#else
inline double least(double a, double b) { return std::min(a, b); }
inline double greatest(double a, double b) { return std::max(a, b); }
#endif

inline double least(double a, double b, double c) { return least(least(a, b), c); }
inline double greatest(double a, double b, double c) { return greatest(greatest(a, b), c); }

}  // namespace remesher
