// SPDX-License-Identifier: MIT
// Writes src/rooms.svg, the picture in src/README.md: node tests/pictures/rooms.js
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { coreRooms } from '../support/rooms.js';
import { roomsPicture } from '../support/rooms_picture.js';
import { root } from '../support/tree.js';

writeFileSync(join(root, 'src/rooms.svg'), roomsPicture(coreRooms, 'remesher'));
