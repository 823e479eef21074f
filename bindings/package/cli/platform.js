// SPDX-License-Identifier: MIT
// Node's platform as the command line has it: in sentences of the core, options are its flags.

import * as node from '../platform_node.js';

export const platform = { ...node, words: (/** @type {string} */ text) => text };
