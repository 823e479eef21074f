// SPDX-License-Identifier: MIT
// The part of the canvas that toolbar and tags leave to a model.

/** CSS pixels that the toolbar takes below a model, and its tag about as many above. Where the
 * canvas is low, as on a phone, a model may reach up between the tags. */
const toolbar = 56, gapAbove = 12, lowCanvas = 440;

/** The least share of the height that a model gets, however low the canvas is. */
const least = 0.5;

/** free: a share of the height; lift: how far the middle of that is above the middle of the canvas.
 * @param {number} height of the canvas, in CSS pixels */
export function clearance(height) {
  const above = height < lowCanvas ? gapAbove : toolbar;
  return { free: Math.max(least, 1 - (toolbar + above) / Math.max(1, height)),
    lift: (toolbar - above) / 2 / Math.max(1, height) };
}
