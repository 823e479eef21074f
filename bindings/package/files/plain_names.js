// SPDX-License-Identifier: MIT
// Decides by name alone whether a model may name a file. It may name files in a folder or below it,
// by the plain names of folders and files. Whatever percent-decoding makes of a name, however often
// it is done, must be such a plain name too.

const longestName = 4096;
const mostDecodings = 8;

/**
 * Decodes byte by byte, as the core does; a malformed sequence stays as it is.
 * @param {string} name
 */
function percentDecoded(name) {
  return name.replace(/(?:%[0-9a-f]{2})+/gi, (run) => {
    const bytes = run.slice(1).split('%').map((digits) => Number.parseInt(digits, 16));
    return new TextDecoder('utf-8', { ignoreBOM: true }).decode(Uint8Array.from(bytes));
  });
}

/** The name, and what each further decoding makes of it. @param {string} name */
function spellingsOf(name) {
  const spellings = [name];
  for (let next = percentDecoded(name); next !== spellings.at(-1); next = percentDecoded(next)) {
    if (spellings.length > mostDecodings) return undefined;
    spellings.push(next);
  }
  return spellings;
}

// eslint-disable-next-line no-control-regex
const control = /[\u0000-\u001f\u007f-\u009f\u2028-\u202e\u2066-\u2069]/;
const device = /^(con|prn|aux|nul|(com|lpt)\d)(\.|$)/i;

/**
 * Windows writes \ where all others write /; both separate here.
 * @param {string} spelling
 * @param {'climbs' | 'stays'} range whether it may climb out of the folder it begins in
 */
function whyNotPlain(spelling, range) {
  if (spelling === '') return 'it has no name';
  if (control.test(spelling)) return 'its name has control characters';
  if (/^[a-z][a-z0-9+.-]+:/i.test(spelling)) return 'it is an address, and nothing is fetched';
  if (/^([a-z]:|[/\\])/i.test(spelling)) return 'its path does not begin in the model’s folder';
  const parts = spelling.split(/[/\\]/);
  if (range === 'stays' && parts.includes('..')) return 'it lies outside of the model’s folder';
  if (parts.some((part) => /^\.(?!\.?$)/.test(part))) return 'it is hidden';
  if (parts.some((part) => device.test(part))) return 'it is a device on Windows';
  return undefined;
}

/**
 * The paths that a reference can mean, from the folder where it stands, with / between their
 * parts; or why it may mean none.
 * @param {string} reference
 * @param {'climbs' | 'stays'} range
 * @returns {{ paths: string[], why?: undefined } | { paths?: undefined, why: string }}
 */
export function plainPaths(reference, range) {
  const spellings = reference.length <= longestName ? spellingsOf(reference) : undefined;
  if (!spellings) return { why: 'its name is too long' };
  for (const spelling of spellings) {
    const why = whyNotPlain(spelling, range);
    if (why) return { why };
  }
  return { paths: spellings.slice(0, 2).map((spelling) => spelling.replaceAll('\\', '/')) };
}
