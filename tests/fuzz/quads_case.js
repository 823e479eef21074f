// SPDX-License-Identifier: MIT
// Cases of quads: the surfaces and files of the other cases, with options that quads have.
import { makeCase } from './cases.js';
import { Dice } from './dice.js';

const shared = ['vertices', 'ratio', 'adaptivity', 'featureAngle', 'boundary', 'maxError'];

/** @param {number} seed @returns {import('./cases.js').Case} */
export function makeQuadsCase(seed) {
  const input = makeCase(seed);
  const dice = new Dice(seed + 1);
  const options = Object.fromEntries(Object.entries(input.options)
    .filter(([name]) => shared.includes(name)));
  options.quads = true;
  if (dice.chance(0.3)) options.exact = true;
  if (dice.chance(0.2)) options.symmetry = 'off';
  if (dice.chance(0.2)) options.quality = 'draft';
  return { ...input, options };
}
