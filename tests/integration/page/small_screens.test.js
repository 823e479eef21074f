// SPDX-License-Identifier: MIT
// The way of most visitors, in small windows and on a phone.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { visit } from '../../support/browser_page.js';
import { eachPurpose } from '../../support/doors.js';

const { page, complaints } = await visit({ hash: '#model=gear&vertices=300', isFirst: true,
  unseen: true, viewport: { width: 1440, height: 900 } });

for (const [screen, size] of Object.entries({ small: [1024, 768], phone: [390, 844] })) {
  test(`each purpose, from the door to the file: ${screen}`, () => eachPurpose(page, size));
}

test('nothing is complained of', () => assert.deepEqual(complaints, []));
