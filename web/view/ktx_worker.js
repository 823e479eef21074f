// SPDX-License-Identifier: MIT
// The worker that decodes KTX2 textures: the decoder makes code as it runs, which the page itself
// does not allow.
import { decodeKtx2 } from 'remesher/ktx2';

addEventListener('message', async ({ data: buffer }) => {
  try {
    const answer = await decodeKtx2(buffer);
    postMessage({ answer }, { transfer: [answer.data.buffer] });
  } catch (error) {
    postMessage({ error: String(error) });
  }
});
