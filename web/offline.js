// SPDX-License-Identifier: MIT
// The service worker: after the first visit the page needs no network. The build writes the list of
// files to keep into it (installable.js).
import { Serwist } from 'serwist';

const precacheEntries = /** @type {any} */ (self).__SW_MANIFEST;

new Serwist({ precacheEntries, skipWaiting: true, clientsClaim: true }).addEventListeners();
