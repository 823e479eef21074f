// SPDX-License-Identifier: MIT
// Everything to save of a result: files, report, picture, and the run as a command line and as
// JavaScript, to copy with one click.
import { cardWords } from 'remesher/card';
import { formats } from 'remesher/formats';
import { element } from '../base/dom.js';
import { language, t } from '../base/i18n.js';
import { objOf } from '../model/guides.js';
import { commandLine, javaScript } from '../model/snippets.js';

/** @typedef {import('../model/session.js').Session} Session */
/** @typedef {import('../model/result.js').Result} Result */
/** @typedef {{ onFormat: (format: string) => void, onLevels: () => void, onCard: () => void,
 *   onReport: () => void, onPicture: (hasBackground: boolean) => void,
 *   onCopy: (text: string) => void,
 *   onFile: (file: import('remesher').NamedBytes) => void }} SavingActs */

/** @param {string} label @param {() => void} onclick @param {string} [className] */
const button = (label, onclick, className = '') =>
  element('button', { type: 'button', className, onclick }, label);

/** One button per format. @param {(format: string) => void} onFormat */
const files = (onFormat) => formats.map((format) =>
  button(format === 'gltf' ? t('download.gltf') : format.toUpperCase(), () => onFormat(format)));

/** @param {string} label @param {string} text @param {(text: string) => void} onCopy */
function snippet(label, text, onCopy) {
  return element('div', { className: 'snippet' },
    element('div', { className: 'inline' }, element('h3', {}, label),
      button(t('copy'), () => onCopy(text), 'link')),
    element('code', { tabIndex: 0 }, text));
}

/** The files that the command needs beside the model: the lines drawn on it.
 * @param {{ name: string, lines: readonly import('remesher').Guide[] }} guides
 * @param {SavingActs} acts */
const guidesNote = ({ name, lines }, { onFile }) =>
  element('p', { className: 'notice', id: 'guides-note' }, t('elsewhere.guides'), ' ',
    button(t('elsewhere.saveGuides', { name }), () =>
      onFile({ name, bytes: new TextEncoder().encode(objOf(lines)) }), 'link'));

/** @param {Session} session @param {Result} result @param {SavingActs} acts */
export function takeawayView({ model }, result, acts) {
  const { options, values } = result;
  const lines = /** @type {import('remesher').Guide[] | undefined} */ (options.guides);
  const guides = lines && 'guides.obj';
  const { units } = options;
  const run = { input: model?.name ?? '', output: result.ownName, guides,
    values: { ...values, ...(units && { units }) } };
  return element('section', { className: 'takeaway', 'aria-label': t('download') },
    element('h2', {}, t('download.others')),
    element('div', { className: 'downloads', role: 'group', 'aria-label': t('download') },
      ...files(acts.onFormat), button(t('download.levels'), acts.onLevels),
      button(cardWords[language()].title, acts.onCard),
      button(t('download.report'), acts.onReport),
      button(t('download.picture'), () => acts.onPicture(true)),
      button(t('download.cutout'), () => acts.onPicture(false))),
    element('details', { className: 'command' },
      element('summary', {}, t('elsewhere')),
      options.density && element('p', { className: 'notice', id: 'no-density' },
        t('elsewhere.noDensity')),
      lines && guides && guidesNote({ name: guides, lines }, acts),
      snippet(t('elsewhere.command'), commandLine(run), acts.onCopy),
      snippet('JavaScript', javaScript(run), acts.onCopy),
      snippet(t('elsewhere.link'), location.href, acts.onCopy)));
}
