// SPDX-License-Identifier: MIT
// The page's wiring: which act follows which event.
import { init } from 'remesher';
import { codecs } from 'remesher/codecs';
import { open, showFacts } from './acts/opening.js';
import { Page } from './acts/page.js';
import { remesh, showReport } from './acts/running.js';
import { Steering } from './acts/steering.js';
import { addCommand, wireCommands } from './base/commands.js';
import { firstLanguage, onLanguage, setLanguage } from './base/i18n.js';
import { readAddress } from './model/address.js';
import { samples } from './model/samples.js';
import { fillMenu, namedFiles, wireIntake } from './panel/intake.js';
import { wireSettings } from './panel/settings.js';

let wished = readAddress(location.hash);
const first = wished.model ?? samples[0].id;
// On their way while the page is still being made. What is wrong is told where it is needed.
const coming = namedFiles(first);
coming.catch(() => {});
init({ codecs }).catch(() => {});

await setLanguage(firstLanguage());
const steering = new Steering();
const page = new Page({
  onSubmit: () => run(), onSettle: () => steering.settle(), onMove: () => move(),
  onStroke: () => steering.stroke(),
});
steering.wire(page);
/** The angle of the feature curves last shown. */
let featureAngle = page.panel.featureAngle;

function move() {
  if (page.panel.featureAngle !== featureAngle) page.surveying.followFeatures();
  featureAngle = page.panel.featureAngle;
  steering.move();
}

function run() {
  steering.stop();
  return page.busy(() => remesh(page));
}

function cancel() {
  steering.stop();
  page.session.cancel();
}

/** The address speaks for the next model only.
 * @param {Promise<import('./files/files.js').PathedFile[]>} items @param {string | null} source */
function take(items, source) {
  const { values } = wished;
  steering.stop();
  wished = { model: null, values: {} };
  void open(page, items, { source, wished: values, onForm: () => steering.begin() });
}

onLanguage(() => {
  page.panel.build();
  fillMenu();
  showFacts(page);
  page.surveying.retell();
  showReport(page);
});
wireIntake(take);
wireSettings(fillMenu);
addCommand('cancel', cancel);
wireCommands();
fillMenu();
take(coming, first);

addEventListener('beforeunload', (event) => {
  if (page.session.isUnsaved) event.preventDefault();  // the browser asks
});
// Only once the visitor has been served: keeping the page takes as long as loading it.
addEventListener('load', () => setTimeout(keepOffline, 3000));

function keepOffline() {
  const { serviceWorker } = navigator;
  // Where it is forbidden, the page needs the network, as any other.
  serviceWorker?.register('./offline.js').catch(() => {});
}

addEventListener('hashchange', () => {  // typed by hand: the page's own changes do not tell
  wished = readAddress(location.hash);
  if (wished.model && wished.model !== page.session.source) {
    take(namedFiles(wished.model), wished.model);
    return;
  }
  page.panel.setValues(wished.values);
  steering.settle();
  void run();
});
