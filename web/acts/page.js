// SPDX-License-Identifier: MIT
// The parts that all acts share: the session, the stage and the form. A later job overtakes an
// earlier one.
import { byId } from '../base/dom.js';
import { timeLeft, words } from '../base/format.js';
import { t, textIfAny } from '../base/i18n.js';
import { Session } from '../model/session.js';
import { setSavable } from '../panel/downloads.js';
import { announce, isAbort, showError, showNews, showProgress } from '../panel/messages.js';
import { Panel } from '../panel/panel.js';
import { Stage } from '../view/stage.js';
import { Guiding } from './guiding.js';
import { Painting } from './painting.js';
import { Pen } from './pen.js';
import { Surveying } from './surveying.js';

/** The page's state. A draft shows no progress, because it is short.
 * @typedef {'idle' | 'busy' | 'drafting'} State */

export class Page {
  session = new Session((event) => this.#onProgress(event));
  stage = new Stage();
  panel;
  surveying;
  pen;
  painting;
  guiding;
  #jobs = 0;
  /** @type {State} */
  #state = 'idle';
  /** When the run began, in milliseconds. */
  #begun = 0;
  /** How far it is. */
  #fraction = 0;

  /** @param {ConstructorParameters<typeof Panel>[1] & { onStroke: () => void }} formActs */
  constructor(formActs) {
    this.panel = new Panel(byId('form', HTMLFormElement), formActs);
    this.surveying = new Surveying(this);
    this.pen = new Pen(this);
    this.painting = new Painting(this, formActs.onStroke);
    this.guiding = new Guiding(this, formActs.onStroke);
  }

  /** @param {import('remesher').ProgressEvent} event */
  #onProgress(event) {
    if (this.#state !== 'busy') return;
    const { phase, fraction } = event;
    if (fraction < this.#fraction) this.#begun = performance.now();  // of another run
    this.#fraction = fraction;
    showProgress({ phase: textIfAny(`phase.${phase}`) ?? words(phase), fraction },
      timeLeft(performance.now() - this.#begun, fraction));
  }

  /** Whether nothing is being made, not even a draft. */
  get isIdle() {
    return this.#state === 'idle';
  }

  /** Names the present work, where nobody knows how long it takes. @param {string} phase */
  tell(phase) {
    if (this.#state === 'busy') showProgress({ phase, fraction: null });
  }

  /** @param {State} state */
  #setState(state) {
    this.#state = state;
    this.#begun = performance.now();
    this.panel.setState(state);
    document.body.dataset.state = state;
    showProgress(state === 'busy' ? { phase: t('preparing'), fraction: 0 } : null);
    if (state === 'idle') setSavable(Boolean(this.session.shown?.number));
  }

  /** Runs a job, sets the page's state meanwhile, and shows the job's error. The end of a job that
   * a later job has overtaken changes neither the state nor the messages.
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
