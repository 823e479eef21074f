// SPDX-License-Identifier: MIT
// A bar chart of smallest angles before and after: six steps of ten degrees, in percent of the
// triangles.
import { angleColors } from '../base/colors.js';
import { number, share } from '../base/format.js';
import { t } from '../base/i18n.js';

const svgNamespace = 'http://www.w3.org/2000/svg';
const size = { width: 300, height: 132, top: 16, base: 112, bar: 18, step: 50 };

/** @param {string} tag @param {Record<string, string | number>} attributes
 * @param {string | number} [text] */
function svg(tag, attributes, text) {
  const node = document.createElementNS(svgNamespace, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, String(value));
  if (text !== undefined) node.textContent = String(text);
  return node;
}

/** @param {number} x @param {number} part of the tallest bar
 * @param {Record<string, string>} look */
function bar(x, part, look) {
  const height = Math.max(part > 0 ? 1 : 0, part * (size.base - size.top));
  return svg('rect', { x, y: size.base - height, width: size.bar, height, rx: 2, ...look });
}

/** @param {number[]} before @param {number[]} after percentages */
function describe(before, after) {
  const steps = before.map((part, i) =>
    t('histogram.step', { from: 10 * i, to: 10 * i + 10, before: share(part),
      after: share(after[i]) }));
  return t('histogram', { steps: steps.join('; ') });
}

/** @param {number[]} before @param {number[]} after percentages, six each */
export function histogram(before, after) {
  const chart = svg('svg', { viewBox: `0 0 ${size.width} ${size.height}`, class: 'histogram',
    role: 'img', 'aria-label': describe(before, after) });
  const tallest = Math.max(...before, ...after);
  for (let i = 0; i < 6; ++i) {
    const middle = (i + 0.5) * size.step;
    const x = middle + 1 + size.bar / 2;
    const y = size.base - (after[i] / tallest) * (size.base - size.top) - 4;
    chart.append(bar(middle - size.bar - 1, before[i] / tallest, { class: 'before' }),
      bar(middle + 1, after[i] / tallest, { fill: angleColors[i] }),
      svg('text', { x: middle, y: size.base + 15, class: 'step' }, `${10 * i}–${10 * i + 10}°`));
    if (after[i] < 0.05) continue;
    const value = number(after[i], { minimumFractionDigits: 1, maximumFractionDigits: 1 });
    chart.append(svg('text', { x, y, class: 'value' }, value));
  }
  const { width, base } = size;
  chart.append(svg('line', { x1: 0, x2: width, y1: base, y2: base, class: 'axis' }));
  return chart;
}
