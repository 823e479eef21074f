// SPDX-License-Identifier: MIT
// What all acts share: the session, the stage, the form, and the rule that a later job overtakes an
// earlier one.
import { byId } from '../base/dom.js';
import { timeLeft, words } from '../base/format.js';
import { t, textIfAny } from '../base/i18n.js';
import { Session } from '../model/session.js';
import { announce, isAbort, showError, showNews, showProgress } from '../panel/messages.js';
import { Panel } from '../panel/panel.js';
import { Stage } from '../view/stage.js';
import { Painting } from './painting.js';
import { Surveying } from './surveying.js';

/** What the page is doing; a draft shows no progress, for it is over at once.
 * @typedef {'idle' | 'busy' | 'drafting'} State */

export class Page {
  session = new Session((event) => this.#onProgress(event));
  stage = new Stage();
  panel;
  surveying;
  painting;
  #jobs = 0;
  /** @type {State} */
  #state = 'idle';
  /** When the state began, in milliseconds. */
  #begun = 0;

  /** @param {ConstructorParameters<typeof Panel>[1] & { onStroke: () => void }} formActs */
  constructor(formActs) {
    this.panel = new Panel(byId('form', HTMLFormElement), formActs);
    this.surveying = new Surveying(this);
    this.painting = new Painting(this, formActs.onStroke);
  }

  /** @param {import('remesher').ProgressEvent} event */
  #onProgress(event) {
    if (this.#state !== 'busy') return;
    const { phase, fraction } = event;
    showProgress({ phase: textIfAny(`phase.${phase}`) ?? words(phase), fraction },
      timeLeft(performance.now() - this.#begun, fraction));
  }

  /** @param {State} state */
  #setState(state) {
    this.#state = state;
    this.#begun = performance.now();
    this.panel.setState(state);
    document.body.dataset.state = state;
    showProgress(state === 'busy' ? { phase: t('preparing'), fraction: 0 } : null);
  }

  /** Runs a job with the page busy around it, its errors shown. A job that a later one has
   * overtaken no longer touches the page.
   * @param {() => Promise<void>} job @param {'busy' | 'drafting'} [state] */
  async busy(job, state = 'busy') {
    const number = ++this.#jobs;
    showError();
    showNews('');
    this.#setState(state);
    try {
      await job();
    } catch (error) {
      if (number === this.#jobs) showError(error);
      if (number === this.#jobs && isAbort(error)) announce(t('cancelled'));
    } finally {
      if (number === this.#jobs) this.#setState('idle');
    }
  }
}
