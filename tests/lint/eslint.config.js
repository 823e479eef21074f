// SPDX-License-Identifier: MIT
// Mistakes only; layout is the editor's business.
import js from '@eslint/js';
import globals from 'globals';

export default [
  { ignores: ['build/', 'dist/', 'web/dist/', 'node_modules/'] },
  js.configs.recommended,
  {
    languageOptions: {
      ecmaVersion: 2023,
      sourceType: 'module',
      globals: { ...globals['shared-node-browser'], ...globals.es2021 },
    },
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    rules: {
      'consistent-return': 'error',
      'eqeqeq': 'error',
      'max-depth': ['error', 3],
      'max-len': ['error', { code: 100, ignoreUrls: true }],
      'max-lines-per-function': ['error', { max: 60, skipComments: true }],
      'max-params': ['error', 4],
      'no-shadow': 'error',
      'no-var': 'error',
      'object-shorthand': 'error',
      'prefer-const': 'error',
      'quotes': ['error', 'single', { avoidEscape: true }],
      'semi': 'error',
    },
  },
  {
    files: ['bindings/*.js', 'bindings/build/*.js', 'bindings/package/*node.js',
      'bindings/package/cli/*.js', 'bindings/package/files/*.js', 'examples/**', 'tests/**',
      'web/serve.js'],
    languageOptions: { globals: globals.node },
  },
  {
    files: ['bindings/package/**/*.js', 'web/**/*.js', 'tests/**'],
    languageOptions: { globals: globals.browser },
  },
];
