// SPDX-License-Identifier: MIT
// A file's bytes, in node. Programs packed for browsers get read_file_browser.js instead, by package.json's "browser".
// A page without a packer loads this one and never calls it.

export async function readBytes(url) {
    const { readFile } = await import('node:fs/promises');
    return readFile(url);
}
