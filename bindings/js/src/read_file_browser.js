// SPDX-License-Identifier: MIT
// In place of read_file.js where a program is packed for browsers: there are no files.

export async function readBytes() {
    throw new Error('there are no files in a browser');
}
