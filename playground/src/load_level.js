// SPDX-License-Identifier: MIT
// The level that the address names, as a world.
const kDefault = 'first.obj';

/** The name after ?level=, if it is one of a file beside the page; else throws. */
export function levelName(search) {
    const name = new URLSearchParams(search).get('level') ?? kDefault;
    if (!/^[\w][\w .+-]*\.(obj|bsp|firma)$/i.test(name)) throw new Error(`${name}: a level is an .obj, .bsp or .firma file beside this page`);
    return name;
}

export async function loadWorld(firma, name) {
    const answer = await fetch(new URL(encodeURIComponent(name), document.baseURI));
    if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
    const bytes = new Uint8Array(await answer.arrayBuffer());
    switch (name.toLowerCase().split('.').pop()) {
        case 'bsp': return firma.worldFromBsp(bytes, { name });
        case 'firma': return firma.unpackWorld(bytes, name);
        default: return firma.worldFromObj(bytes, { name });
    }
}
