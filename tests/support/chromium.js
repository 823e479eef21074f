// SPDX-License-Identifier: MIT
// Chromium as the tests start it: without a display, WebGL in software.
import { chromium } from 'playwright-core';

const options = [
  '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync',
  '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
];

export function startChromium() {
  return chromium.launch({ executablePath: '/usr/bin/chromium', args: options });
}
