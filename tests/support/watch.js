// SPDX-License-Identifier: MIT
// Ends runs that do not end, by this process's time on its cores, whatever else the machine does.

/** A signal that aborts after `limit` seconds of processor time; `stop` ends the watch.
 * @param {number} [limit] */
export function watch(limit = 60) {
  const controller = new AbortController();
  const begin = process.cpuUsage();
  const seconds = () => {
    const { user, system } = process.cpuUsage(begin);
    return (user + system) / 1e6;
  };
  const timer = setInterval(() => {
    if (seconds() > limit) controller.abort();
  }, 500);
  return { signal: controller.signal, limit, seconds, stop: () => clearInterval(timer) };
}
