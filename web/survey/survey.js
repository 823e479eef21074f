// SPDX-License-Identifier: MIT
// The page's side of the survey: questions to its worker, answers as promises.

/** @typedef {import('./survey_worker.js').Questions} Questions */

export class Survey {
  #worker = new Worker(new URL('./survey_worker.js', import.meta.url), { type: 'module' });
  #number = 0;
  /** @type {Map<number, { resolve: (answer: any) => void, reject: (error: Error) => void }>} */
  #waiting = new Map();

  constructor() {
    this.#worker.addEventListener('message', ({ data: { number, answer, error } }) => {
      const waiting = this.#waiting.get(number);
      this.#waiting.delete(number);
      if (error) waiting?.reject(new Error(error));
      else waiting?.resolve(answer);
    });
  }

  /**
   * Answers come in the order of the questions.
   * @template {keyof Questions} Name
   * @param {Name} question
   * @param {Parameters<Questions[Name]>[0]} [request]
   * @param {Transferable[]} [transfer] the request's buffers that move to the worker
   * @returns {Promise<ReturnType<Questions[Name]>>}
   */
  ask(question, request, transfer = []) {
    const number = ++this.#number;
    this.#worker.postMessage({ number, question, request }, transfer);
    return new Promise((resolve, reject) => this.#waiting.set(number, { resolve, reject }));
  }
}
