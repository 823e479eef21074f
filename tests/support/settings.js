// SPDX-License-Identifier: MIT
// The settings that the page keeps in the browser, and texts that are none of their values.
import { filesUnder, readText } from './tree.js';

/** The scripts of the page: path and text. */
export const sources = filesUnder('web', /\.js$/).map((file) => [file, readText(file)]);

/** The names of all settings. */
export const names = sources.flatMap(([, text]) =>
  Array.from(text.matchAll(/(?:new Setting|switchSetting)\('([\w-]+)'/g), ([, name]) => name));

export const damaged = ['', 'x{', 'null', '[]', '{}', '[null]', '{"key":"x"}', '"de"', '1e999',
  'true', '__proto__', 'constructor', '\0', `"${'x'.repeat(2 ** 19)}"`,
  `[${'0,'.repeat(2 ** 18)}0]`];
