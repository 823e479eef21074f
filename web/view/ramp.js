// SPDX-License-Identifier: MIT
// Maps a number between 0 and 1 to a colour, interpolated between the colours of a list.
import { Color } from 'three';

/** @param {readonly string[]} colors evenly spread from 0 to 1
 * @returns {(share: number, color: Color) => void} sets the colour */
export function ramp(colors) {
  const palette = colors.map((color) => new Color(color));
  return (share, color) => {
    const place = Math.min(1, Math.max(0, share)) * (palette.length - 1);
    const step = Math.min(palette.length - 2, Math.floor(place));
    color.lerpColors(palette[step], palette[step + 1], place - step);
  };
}
