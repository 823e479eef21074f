// SPDX-License-Identifier: MIT
// Colours that mean something: the same in the picture, in charts and in legends.

/** One colour for each ten degrees of a triangle's smallest angle: 50 to 60 is the best. */
export const angleColors = ['#9f1d35', '#d1495b', '#ee9b5f', '#f2d492', '#9ccfb4', '#2a9d8f'];

/** Even steps from distance 0 to the largest; they also differ in lightness. */
export const distanceColors = ['#f4f1e6', '#cfe3c8', '#8cc6b8', '#4a9fae', '#33709e', '#3d3f86',
  '#3a1550'];

/** From sparse over even to dense. */
export const densityColors = ['#2f6db3', '#e9e4da', '#c2452f'];

/** Irregular vertices of quads: valence three, five, or another number except four. */
export const valenceColors = { three: '#1c7ed6', five: '#e8590c', other: '#ae3ec9' };

/** Lines drawn over the surfaces. */
export const lineColors = { features: '#e8590c', boundary: '#1971c2', nonManifold: '#c2255c',
  flipped: '#9c36b5', probe: '#111111', field: '#0b7285', direction: '#6741d9', loop: '#d6336c',
  drawn: '#111111' };

/** @param {readonly string[]} colors as CSS wants a gradient of them */
export const gradient = (colors) => `linear-gradient(to right, ${colors.join(', ')})`;
