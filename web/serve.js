// SPDX-License-Identifier: MIT
// Builds the page, copies build/docs beside it if that exists, and serves both on this computer:
// node web/serve.js [port]. The variable PORT works, too; if the port is taken, the next is tried.
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { build, preview } from 'vite';
import { documentation } from './documentation.js';

const configFile = fileURLToPath(new URL('./vite.config.js', import.meta.url));
const docs = fileURLToPath(new URL('../build/docs', import.meta.url));
const port = Number(process.argv[2] ?? process.env.PORT ?? 8080);

console.log('Building the page');
const plugins = existsSync(docs) ? [documentation(docs)] : [];
await build({ configFile, logLevel: 'warn', plugins });
const server = await preview({ configFile, logLevel: 'warn', preview: { port } });
console.log(`remesher is ready at ${server.resolvedUrls?.local[0]} (stop with Ctrl+C)`);
