// SPDX-License-Identifier: MIT
// Every failure comes back to JavaScript as { error: { code, message, hint } }.
#pragma once

#include <emscripten/val.h>

#include <exception>
#include <new>
#include <string>

#include "remesher.h"

namespace remesher {

inline emscripten::val failure(ErrorCode code, const std::string& message,
                               const std::string& hint) {
  using emscripten::val;
  val error = val::object();
  error.set("code", std::string(name(code)));
  error.set("message", message);
  error.set("hint", hint);
  val result = val::object();
  result.set("error", error);
  return result;
}

// body: the work of a function of the module; it returns a plain object.
template <class Body>
emscripten::val guarded(Body body) {
  try {
    return body();
  } catch (const Error& error) {
    return failure(error.code, error.what(), error.hint);
  } catch (const std::bad_alloc&) {
    return failure(ErrorCode::OutOfMemory, "The run needs more memory than WebAssembly can have.",
                   "Ask for fewer vertices, or give the model in parts.");
  } catch (const std::exception& error) {
    return failure(ErrorCode::Internal, error.what(), "Please report this as a bug.");
  }
}

}  // namespace remesher
