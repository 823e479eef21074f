// SPDX-License-Identifier: MIT
// The texts that an editor shows: TypeScript's language server, asked over the Language Server
// Protocol.
import { spawn } from 'node:child_process';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

import { root } from './tree.js';

/** The messages in a stream of `Content-Length: n`, an empty line, and n bytes each. */
async function* messagesIn(stream) {
  let rest = Buffer.alloc(0);
  for await (const chunk of stream) {
    rest = Buffer.concat([rest, chunk]);
    for (;;) {
      const head = rest.indexOf('\r\n\r\n');
      if (head < 0) break;
      const [, length] = /Content-Length: (\d+)/.exec(rest.toString('utf8', 0, head));
      const end = head + 4 + Number(length);
      if (rest.length < end) break;
      yield JSON.parse(rest.toString('utf8', head + 4, end));
      rest = rest.subarray(end);
    }
  }
}

export class Editor {
  #server = spawn(join(root, 'node_modules/typescript-7/bin/tsc'), ['--lsp', '--stdio'],
    { stdio: ['pipe', 'pipe', 'ignore'] });
  #waiting = new Map();
  #asked = 0;

  /** @param {string} folder the project's */
  static async open(folder) {
    const editor = new Editor();
    void editor.#listen();
    await editor.#ask('initialize',
      { processId: process.pid, rootUri: pathToFileURL(folder).href, capabilities: {} });
    editor.#send({ method: 'initialized', params: {} });
    return editor;
  }

  /** @param {string} file @param {string} text */
  show(file, text) {
    this.#send({
      method: 'textDocument/didOpen',
      params: { textDocument: {
        uri: pathToFileURL(file).href, languageId: 'typescript', version: 1, text,
      } },
    });
  }

  /** The text shown when the mouse hovers over a place of a file. @returns {Promise<string>} */
  async hover(file, { line, character }) {
    const answer = await this.#ask('textDocument/hover',
      { textDocument: { uri: pathToFileURL(file).href }, position: { line, character } });
    const contents = answer?.contents ?? '';
    return typeof contents === 'string' ? contents : contents.value;
  }

  close() {
    this.#server.kill();
  }

  async #listen() {
    for await (const message of messagesIn(this.#server.stdout)) {
      const isQuestion = message.method !== undefined && message.id !== undefined;
      if (isQuestion) this.#send({ id: message.id, result: null });
      else this.#waiting.get(message.id)?.(message);
    }
  }

  async #ask(method, params) {
    const id = (this.#asked += 1);
    const answer = new Promise((resolve) => this.#waiting.set(id, resolve));
    this.#send({ id, method, params });
    const { result, error } = await answer;
    if (error) throw new Error(`${method}: ${error.message}`);
    return result;
  }

  #send(message) {
    const body = JSON.stringify({ jsonrpc: '2.0', ...message });
    this.#server.stdin.write(`Content-Length: ${Buffer.byteLength(body)}\r\n\r\n${body}`);
  }
}
