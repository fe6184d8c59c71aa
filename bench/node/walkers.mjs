// SPDX-License-Identifier: MIT
// Who moves players: a capsule of 0.3 m and 1.8 m, steps of 0.4 m, slopes of 45 degrees, 60 ticks a second; each library at
// the settings, and in the way, of its own examples.
//
// A mover is { name, place(walker, position), move(walker, velocity, jump), at(walker) }; walkers are numbers from 0 on, and
// stand for players that do not meet each other. at() gives the feet.
import Rapier from '@dimforge/rapier3d-simd-compat';
import initJolt from 'jolt-physics/wasm-compat';
import { joltLevel, joltWorld, MOVING, TICK } from './body_engines.mjs';
import { SIZE } from './course.mjs';

export const STEP = 0.4;
const GRAVITY = 9.81;
const JUMP = 4.4;
const SLOPE = Math.PI / 4;
const HALF = SIZE.height / 2 - SIZE.radius; // of the capsule's segment
const UPRIGHT = [Math.SQRT1_2, 0, 0, Math.SQRT1_2]; // from y to z

export function firmaMover(games, world) {
    const capsule = games.playerCapsule({ radius: SIZE.radius, height: SIZE.height });
    const rules = { stepHeight: STEP, maxSlope: SLOPE, gravity: GRAVITY, jumpSpeed: JUMP };
    const players = [];
    return {
        name: 'Firma',
        place: (walker, position) => (players[walker] = { position }),
        move(walker, velocity, jump) {
            players[walker] = games.movePlayer(world, capsule, players[walker], { velocity, jump }, TICK, rules).player;
        },
        at: (walker) => players[walker].position,
    };
}

/** As CharacterVirtual's sample drives it: velocities of the ground and of falling by hand, then ExtendedUpdate(). */
export async function joltMover(mesh) {
    const J = await initJolt();
    const jolt = joltWorld(J);
    const system = jolt.GetPhysicsSystem();
    joltLevel(J, system, mesh);
    system.OptimizeBroadPhase();
    const up = new J.Vec3(0, 0, 1);
    const shape = new J.RotatedTranslatedShapeSettings(new J.Vec3(0, 0, SIZE.height / 2), new J.Quat(...UPRIGHT), new J.CapsuleShapeSettings(HALF, SIZE.radius)).Create().Get();
    const settings = new J.CharacterVirtualSettings();
    settings.mShape = shape;
    settings.mUp = up;
    settings.mMaxSlopeAngle = SLOPE;
    settings.mSupportingVolume = new J.Plane(up, -SIZE.radius);
    settings.mEnhancedInternalEdgeRemoval = true;
    const update = new J.ExtendedUpdateSettings();
    update.mStickToFloorStepDown = new J.Vec3(0, 0, -0.5);
    update.mWalkStairsStepUp = new J.Vec3(0, 0, STEP);
    const filters = [
        new J.DefaultBroadPhaseLayerFilter(jolt.GetObjectVsBroadPhaseLayerFilter(), MOVING),
        new J.DefaultObjectLayerFilter(jolt.GetObjectLayerPairFilter(), MOVING),
        new J.BodyFilter(),
        new J.ShapeFilter(),
    ];
    const allocator = jolt.GetTempAllocator();
    const [gravity, wished, next, from] = [new J.Vec3(0, 0, -GRAVITY), new J.Vec3(0, 0, 0), new J.Vec3(0, 0, 0), new J.RVec3(0, 0, 0)];
    const unturned = new J.Quat(0, 0, 0, 1);
    const characters = [];
    return {
        name: 'jolt-physics',
        place(walker, position) {
            from.Set(...position);
            characters[walker] ??= new J.CharacterVirtual(settings, from, unturned, system);
            characters[walker].SetPosition(from);
            next.Set(0, 0, 0);
            characters[walker].SetLinearVelocity(next);
        },
        move(walker, velocity, jump) {
            const character = characters[walker];
            const falling = character.GetLinearVelocity().GetZ();
            const onGround = character.GetGroundState() === J.EGroundState_OnGround;
            let rise = falling;
            if (onGround && falling < 0.1) rise = jump ? JUMP : 0;
            wished.Set(velocity[0], velocity[1], 0);
            const allowed = character.CancelVelocityTowardsSteepSlopes(wished);
            // Its sample has a listener that keeps who stands from sliding down: the same without one.
            const stands = onGround && !jump && velocity[0] === 0 && velocity[1] === 0;
            next.Set(allowed.GetX(), allowed.GetY(), stands ? 0 : rise - GRAVITY * TICK);
            character.SetLinearVelocity(next);
            character.ExtendedUpdate(TICK, gravity, update, ...filters, allocator);
        },
        at(walker) {
            const position = characters[walker].GetPosition();
            return [position.GetX(), position.GetY(), position.GetZ()];
        },
    };
}

/** KinematicCharacterController as its guide has it: gravity by hand, the movement computed, the collider put there. */
export async function rapierMover(mesh) {
    await Rapier.init();
    const world = new Rapier.World({ x: 0, y: 0, z: -GRAVITY });
    world.createCollider(Rapier.ColliderDesc.trimesh(Float32Array.from(mesh.positions), mesh.corners, Rapier.TriMeshFlags.FIX_INTERNAL_EDGES));
    const [x, y, z, w] = UPRIGHT;
    const collider = world.createCollider(Rapier.ColliderDesc.capsule(HALF, SIZE.radius).setRotation({ x, y, z, w }));
    world.step();
    const controller = world.createCharacterController(0.01);
    controller.setUp({ x: 0, y: 0, z: 1 });
    controller.setMaxSlopeClimbAngle(SLOPE);
    controller.setMinSlopeSlideAngle(SLOPE);
    controller.enableAutostep(STEP, 0.2, false);
    controller.enableSnapToGround(0.5);
    const walkers = [];
    const wished = { x: 0, y: 0, z: 0 };
    const place = { x: 0, y: 0, z: 0 };
    const middle = ([px, py, pz]) => Object.assign(place, { x: px, y: py, z: pz + SIZE.height / 2 });
    return {
        name: 'rapier3d',
        place: (walker, position) => (walkers[walker] = { at: [...position], rise: 0, grounded: false }),
        move(walker, velocity, jump) {
            const one = walkers[walker];
            if (one.grounded) one.rise = jump ? JUMP : 0;
            one.rise -= GRAVITY * TICK;
            collider.setTranslation(middle(one.at));
            [wished.x, wished.y, wished.z] = [velocity[0] * TICK, velocity[1] * TICK, one.rise * TICK];
            controller.computeColliderMovement(collider, wished);
            const by = controller.computedMovement();
            one.grounded = controller.computedGrounded();
            for (const [axis, name] of ['x', 'y', 'z'].entries()) one.at[axis] += by[name];
        },
        at: (walker) => walkers[walker].at,
    };
}
