// SPDX-License-Identifier: MIT
// Rules for carving, as the module takes them.
import { badCall } from './errors.js';
import { RULES, ZONE } from './layout.js';
import { doubles, flag, longWord, number, object, text, vector } from './arguments.js';

const PLACE = 'withRules';
const ZONE_NAMES = ['name', 'low', 'high', 'hardness'];
const LIMITS = ['maxFaces', 'maxCandidateFaces', 'maxNewFaces', 'maxCutterTriangles', 'maxPairs', 'maxCorners'];
const NAMES = ['zones', 'hardness', ...LIMITS, 'maxCutterSize', 'mergeShare', 'openFaces'];

function putZones(core, lent, zones) {
    const at = lent.take(zones.length * ZONE.sizeof);
    zones.forEach((zone, k) => {
        const place = `${PLACE}: zone ${k}`;
        object(zone, place, 'the zone', ZONE_NAMES);
        const low = vector(zone.low, 3, place, 'low');
        const high = vector(zone.high, 3, place, 'high');
        const hardness = number(zone.hardness, place, 'hardness');
        const name = lent.text(text(zone.name, place, 'name'));
        const start = at + k * ZONE.sizeof;
        core.setU32(start + ZONE.name, name);
        core.setVector(start + ZONE.low, low);
        core.setVector(start + ZONE.high, high);
        core.setF64(start + ZONE.hardness, hardness);
    });
    return at;
}

/** @returns the address of the struct */
export function putRules(core, lent, rules) {
    const given = object(rules, PLACE, 'the rules', NAMES);
    const { zones = [], hardness = [], maxCutterSize = 0, mergeShare = 0, openFaces = true } = given;
    if (!Array.isArray(zones)) throw badCall(PLACE, 'zones must be an array');
    doubles(hardness, 1, PLACE, 'hardness');
    const limits = LIMITS.map((name) => longWord(given[name] === undefined ? 0 : given[name], PLACE, name));
    number(maxCutterSize, PLACE, 'maxCutterSize');
    number(mergeShare, PLACE, 'mergeShare');
    flag(openFaces, PLACE, 'openFaces');
    const zonesAt = putZones(core, lent, zones);
    const hardnessAt = lent.doubles(hardness);
    const at = core.at.rules;
    core.setU32(at + RULES.size, RULES.sizeof);
    core.setU32(at + RULES.reserved, 0);
    core.setU32(at + RULES.zones, zonesAt);
    core.setU32(at + RULES.zoneCount, zones.length);
    core.setU32(at + RULES.hardness, hardnessAt);
    core.setU32(at + RULES.hardnessCount, hardness.length);
    LIMITS.forEach((name, k) => core.setU64(at + RULES[name], limits[k]));
    core.setF64(at + RULES.maxCutterSize, maxCutterSize);
    core.setF64(at + RULES.mergeShare, mergeShare);
    core.setU32(at + RULES.noOpenFaces, openFaces ? 0 : 1);
    core.setU32(at + RULES.reserved2, 0);
    return at;
}
