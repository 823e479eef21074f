// SPDX-License-Identifier: MIT
// Signs of determinants, decided exactly: in floating point where its error cannot matter
// [Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic"], else in whole numbers.

/** @typedef {ArrayLike<number>} Point */

const unit = 2 ** -53;
const error2 = (3 + 16 * unit) * unit;
const error3 = (7 + 56 * unit) * unit;

const word = new DataView(new ArrayBuffer(8));

/** A number as mantissa · 2^exponent, the mantissa whole. @param {number} x */
function split(x) {
  word.setFloat64(0, x);
  const high = word.getUint32(0);
  const biased = (high >>> 20) & 2047;
  const fraction = (high & 0xfffff) * 2 ** 32 + word.getUint32(4);
  const mantissa = biased === 0 ? fraction : fraction + 2 ** 52;
  return { mantissa: x < 0 ? -mantissa : mantissa, exponent: Math.max(biased, 1) - 1075 };
}

/** The numbers as whole multiples of one power of two. @param {number[]} values */
export function wholes(values) {
  const parts = values.map(split);
  const least = parts.reduce((low, { mantissa, exponent }) =>
    (mantissa === 0 ? low : Math.min(low, exponent)), 2048);
  return parts.map(({ mantissa, exponent }) =>
    (mantissa === 0 ? 0n : BigInt(mantissa) << BigInt(exponent - least)));
}

const signOf = (/** @type {bigint} */ x) => (x > 0n ? 1 : x < 0n ? -1 : 0);

function exact2(values) {
  const [ax, ay, bx, by, cx, cy] = wholes(values);
  return signOf((ax - cx) * (by - cy) - (ay - cy) * (bx - cx));
}

/** 1 if a, b, c turn left in the plane of the axes x and y, −1 if right, 0 on a line.
 * @param {Point} a @param {Point} b @param {Point} c @param {number[]} axes */
export function orient2(a, b, c, [x, y]) {
  const left = (a[x] - c[x]) * (b[y] - c[y]);
  const right = (a[y] - c[y]) * (b[x] - c[x]);
  const det = left - right;
  if (Math.abs(det) > error2 * (Math.abs(left) + Math.abs(right)) + 1e-300) return Math.sign(det);
  return exact2([a[x], a[y], b[x], b[y], c[x], c[y]]);
}

function exact3(values) {
  const v = wholes(values);
  const [ax, ay, az, bx, by, bz, cx, cy, cz] =
    v.slice(0, 9).map((value, i) => value - v[9 + (i % 3)]);
  return signOf(ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx));
}

/** The sign of the determinant of a − d, b − d, c − d: on which side of the plane d is. 0: in it.
 * @param {Point} a @param {Point} b @param {Point} c @param {Point} d */
export function orient3(a, b, c, d) {
  const ax = a[0] - d[0], ay = a[1] - d[1], az = a[2] - d[2];
  const bx = b[0] - d[0], by = b[1] - d[1], bz = b[2] - d[2];
  const cx = c[0] - d[0], cy = c[1] - d[1], cz = c[2] - d[2];
  const yz = by * cz, zy = bz * cy, xz = bx * cz, zx = bz * cx, xy = bx * cy, yx = by * cx;
  const det = ax * (yz - zy) - ay * (xz - zx) + az * (xy - yx);
  const size = Math.abs(ax) * (Math.abs(yz) + Math.abs(zy))
    + Math.abs(ay) * (Math.abs(xz) + Math.abs(zx)) + Math.abs(az) * (Math.abs(xy) + Math.abs(yx));
  if (Math.abs(det) > error3 * size + 1e-300) return Math.sign(det);
  return exact3([...a, ...b, ...c, ...d]);
}
