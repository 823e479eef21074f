// SPDX-License-Identifier: MIT
// Starts Chromium for tests: without a display, with WebGL in software.
import { chromium } from 'playwright-core';

import { findChromium } from '../../bindings/build/needs.js';
import { thisSystem } from '../../bindings/build/system.js';

/** As in late_tiering.js, but sooner: pages also remesh large models. */
const tiering = '--js-flags=--wasm-tiering-budget=20000000';

const options = [
  '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync',
  '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', tiering,
];

/** The software renderer does WebGL, and nothing else of a page. */
const leanOptions = ['--disable-gpu-compositing', '--disable-gpu-rasterization'];

export function startChromium({ isLean = false } = {}) {
  const args = isLean ? [...options, ...leanOptions] : options;
  return chromium.launch({ executablePath: findChromium(thisSystem()), args });
}
