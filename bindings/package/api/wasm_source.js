// SPDX-License-Identifier: MIT
// Compiles the WebAssembly from wherever it is, with errors that say what to do. The failure people
// meet most is a server that answers with its index page.

import { RemeshError } from '../base/errors.js';

export const sayWhere =
  'Serve it beside the script, or say where it is: init({ wasmUrl }), or '
  + 'for the small engine init({ arrays: { wasmUrl } }).';

/** @param {Uint8Array} bytes @param {string} where */
function checkMagic(bytes, where) {
  if (bytes.length >= 4 && bytes[0] === 0 && bytes[1] === 0x61 && bytes[2] === 0x73) return;
  const isPage = bytes[0] === 0x3c;
  throw new RemeshError('INTERNAL',
    `${where} is not WebAssembly${isPage ? ': the server sent an HTML page' : ''}.`, sayWhere);
}

/** @param {Promise<WebAssembly.Module>} compilation @param {string} where */
async function whole(compilation, where) {
  try {
    return await compilation;
  } catch (cause) {
    throw new RemeshError('INTERNAL', `${where} is broken or not WebAssembly.`, sayWhere,
      { cause });
  }
}

/**
 * @param {BufferSource} binary
 * @param {string} where
 * @returns {Promise<WebAssembly.Module>}
 */
export async function compileBinary(binary, where) {
  const bytes = ArrayBuffer.isView(binary)
    ? new Uint8Array(binary.buffer, binary.byteOffset, binary.byteLength)
    : new Uint8Array(binary);
  checkMagic(bytes, where);
  return whole(WebAssembly.compile(binary), where);
}

/** @param {string | URL} url @returns {Promise<WebAssembly.Module>} */
export async function compileUrl(url) {
  let response;
  try {
    response = await fetch(url);
  } catch (cause) {
    throw new RemeshError('INTERNAL', `${url} cannot be fetched.`, sayWhere, { cause });
  }
  if (!response.ok) {
    throw new RemeshError('INTERNAL', `${url} cannot be fetched: status ${response.status}.`,
      sayWhere);
  }
  if (response.headers.get('content-type') === 'application/wasm') {
    return whole(WebAssembly.compileStreaming(response), String(url));
  }
  return compileBinary(await response.arrayBuffer(), String(url));
}
