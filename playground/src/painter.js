// SPDX-License-Identifier: MIT
// The colour of a face, and what its surface is like, from its material's name and where it came from.
/** Kinds of surface that the shader knows: see surface_material.js. */
export const kKinds = {
    plain: 0, panels: 1, rock: 2, ground: 3, sky: 4,
    brick: 5, concrete: 6, wood: 7, steel: 8, // the inside of what was cut, by its matter
    glass: 9, water: 10,
};
/** From this one on they are not solid to the eye. */
export const kFirstClear = kKinds.glass;

/** The first pattern that a material's name fits gives its colour and its kind. */
const kLooks = [
    [/^matter\/brick/, [0xae, 0x5f, 0x45], 'brick'],
    [/^matter\/concrete/, [0x9d, 0x9b, 0x95], 'concrete'],
    [/^matter\/wood/, [0xb0, 0x85, 0x50], 'wood'],
    [/^matter\/steel/, [0x76, 0x7d, 0x86], 'steel'],
    [/^matter\/rock/, [0x98, 0x83, 0x6a], 'rock'],
    [/^matter\/glass/, [0xbf, 0xdc, 0xe2], 'glass'],
    [/sky/, [0xa9, 0xc7, 0xe8], 'sky'],
    [/water|liquid/, [0x4f, 0x86, 0x96], 'water'],
    [/glass/, [0xbf, 0xdc, 0xe2], 'glass'],
    [/rubble|crater/, [0xb4, 0x82, 0x58], 'rock'],
    [/rock|stone|cliff|tunnel/, [0x8a, 0x7c, 0x6c], 'rock'],
    [/asphalt|rubber|coal|board/, [0x4d, 0x4f, 0x52], 'ground'],
    [/gravel/, [0x93, 0x8c, 0x7e], 'ground'],
    [/ground|grass|dirt|sand|terrain/, [0x7d, 0x86, 0x58], 'ground'],
    [/brick_dark/, [0x86, 0x62, 0x55], 'panels'],
    [/brick/, [0xa8, 0x7a, 0x66], 'panels'],
    [/blue/, [0x5d, 0x80, 0xa6], 'panels'],
    [/green/, [0x7f, 0x96, 0x78], 'panels'],
    [/red|drum/, [0xa6, 0x4f, 0x43], 'panels'],
    [/yellow|hazard/, [0xc9, 0xa2, 0x3c], 'plain'],
    [/rust/, [0x8f, 0x5f, 0x45], 'panels'],
    [/wood|timber|crate|chair|table|door/, [0x97, 0x77, 0x52], 'plain'],
    [/lamp/, [0xf4, 0xec, 0xd0], 'plain'],
    [/plaster|porcelain|white|light/, [0xbd, 0xb8, 0xaa], 'plain'],
    [/tiles|linoleum|carpet/, [0x93, 0x97, 0x94], 'panels'],
    [/bridge|metal|iron|grate|steel|deck|machine|tank|pipe|locker|cabinet|radiator/, [0x6f, 0x86, 0x9c], 'panels'],
    [/concrete|facade/, [0x97, 0x95, 0x8f], 'panels'],
    [/pillar|column/, [0xb3, 0xa3, 0x8b], 'plain'],
    [/stair|step/, [0xa5, 0x96, 0x82], 'plain'],
    [/ceil|roof/, [0x8c, 0x92, 0x99], 'plain'],
    [/floor/, [0x87, 0x83, 0x7b], 'panels'],
    [/./, [0xa9, 0xaa, 0xa4], 'panels'],
];

const known = new Map();
function lookOf(name) {
    if (!known.has(name)) {
        const [, colour, kind] = kLooks.find(([pattern]) => pattern.test(name.toLowerCase() || 'wall'));
        known.set(name, { colour, kind: kKinds[kind] });
    }
    return known.get(name);
}
const kRubble = lookOf('rubble');
/** How much darker the bottom of a crater is than its rim. */
const kDarker = 0.62;

/** A number in [0, 1) that two integers give. */
function chance(a, b) {
    let h = Math.imul(a ^ 0x9e3779b9, 0x85ebca6b) ^ Math.imul(b + 0x7f4a7c15, 0xc2b2ae35);
    h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
    return ((h ^ (h >>> 13)) >>> 0) / 4294967296;
}

export class Painter {
    /** @param depth  (edit, point): how deep a point lies in the crater of an edit, in its radii */
    constructor(materials, depth) {
        this.looks = [];
        this.depth = depth;
        this.learn(materials);
    }

    /** Edits may add materials. */
    learn(materials) {
        this.unnamed = materials.indexOf('');
        for (let k = this.looks.length; k < materials.length; ++k) this.looks.push(lookOf(materials[k]));
    }

    /** A colour, 0..255 each, of a material's name: what flies from there. */
    dustOf(name) {
        return lookOf(name).colour;
    }

    /** Faces that an edit made in the matter without a name have no material: they are rubble. */
    #look(material, edit) {
        return edit > 0 && this.unnamed === material ? kRubble : this.looks[material];
    }

    /**
     * Puts red, green, blue and kind of a corner of a face into `out`.
     * @param face  { material, source, sourceEdit }
     */
    paint(face, x, y, z, out) {
        const edit = face.sourceEdit;
        const { colour, kind } = this.#look(face.material, edit);
        let light = kind === kKinds.sky ? 1 : 0.97 + 0.06 * chance(face.source, edit);
        let warm = 0;
        if (edit > 0) {
            // Deep in the rock it is darker and redder. By the place alone: facets that meet have one colour there.
            const depth = Math.max(0, Math.min(1, this.depth(edit, [x, y, z])));
            light = 1.14 - kDarker * depth;
            warm = 0.05 * depth;
        }
        out[0] = Math.min(255, colour[0] * light * (1 + warm));
        out[1] = Math.min(255, colour[1] * light);
        out[2] = Math.min(255, colour[2] * light * (1 - warm));
        out[3] = kind;
    }
}
