// SPDX-License-Identifier: MIT
// What all acts share: the session, the stage, the form, and the rule that a later job overtakes an
// earlier one.
import { byId } from '../base/dom.js';
import { t } from '../base/i18n.js';
import { Session } from '../model/session.js';
import { announce, isAbort, showError, showNews, showProgress } from '../panel/messages.js';
import { Panel } from '../panel/panel.js';
import { Stage } from '../view/stage.js';

export class Page {
  session = new Session((event) => showProgress(event));
  stage = new Stage();
  panel;
  #jobs = 0;

  /** @param {() => void} onSubmit of the form */
  constructor(onSubmit) {
    this.panel = new Panel(byId('form', HTMLFormElement), onSubmit);
  }

  /** @param {'idle' | 'busy'} state */
  #setState(state) {
    this.panel.setState(state);
    document.body.dataset.state = state;
    showProgress(state === 'busy' ? { phase: t('preparing'), fraction: 0 } : null);
  }

  /** Runs a job with the page busy around it, its errors shown. A job that a later one has
   * overtaken no longer touches the page.
   * @param {() => Promise<void>} job */
  async busy(job) {
    const number = ++this.#jobs;
    showError();
    showNews('');
    this.#setState('busy');
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
