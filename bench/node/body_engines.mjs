// SPDX-License-Identifier: MIT
// Who moves bodies, as the benchmark drives them: each at settings that its own documents advise.
//
// An engine is { name, start(scene), step(), read(states), finish() }. A step is a sixtieth of a second. read() fills, for each
// body, thirteen numbers (position of the centre of mass, rotation, velocity, spin) and whether it sleeps.
import Rapier from '@dimforge/rapier3d-simd-compat';
import initJolt from 'jolt-physics/wasm-compat';

export const TICK = 1 / 60;
export const NUMBERS = 13;
/** Of the level: its friction, as Firma has it; of two that touch the larger restitution counts. */
const FRICTION = 0.6;

/** Room for what read() fills. */
export const statesOf = (count) => ({ numbers: new Float64Array(NUMBERS * count), asleep: new Uint8Array(count) });

export function firmaBodies(games) {
    let bodies, world, ids;
    return {
        name: 'Firma',
        start(scene) {
            bodies = games.bodies();
            world = scene.level.world;
            ids = scene.bodies.map(({ spheres, mass, inertia, ...body }) => {
                const [x, y, z] = inertia;
                const shape = games.bodyShape(spheres, { volume: 1, mass, centre: [0, 0, 0], inertia: [x, 0, 0, 0, y, 0, 0, 0, z] });
                const id = bodies.add(shape, { position: body.position, rotation: body.rotation });
                shape.release();
                const { velocity, spin, friction, restitution } = body;
                bodies.set(id, { velocity, spin, friction, restitution });
                return id;
            });
        },
        step: () => bodies.step(world, TICK),
        read({ numbers, asleep }) {
            ids.forEach((id, k) => {
                const body = bodies.get(id);
                numbers.set([...body.position, ...body.rotation, ...body.velocity, ...body.spin], NUMBERS * k);
                asleep[k] = body.asleep;
            });
        },
        finish: () => bodies.release(),
    };
}

export const [STILL, MOVING] = [0, 1];

/** A world of two layers: what stands, and what moves. */
export function joltWorld(J) {
    const settings = new J.JoltSettings();
    const pairs = new J.ObjectLayerPairFilterTable(2);
    pairs.EnableCollision(STILL, MOVING);
    pairs.EnableCollision(MOVING, MOVING);
    const layers = new J.BroadPhaseLayerInterfaceTable(2, 2);
    for (const layer of [STILL, MOVING]) layers.MapObjectToBroadPhaseLayer(layer, new J.BroadPhaseLayer(layer));
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
    const jolt = new J.JoltInterface(settings);
    jolt.GetPhysicsSystem().SetGravity(new J.Vec3(0, 0, -9.81));
    return jolt;
}

export function joltMeshShape(J, mesh) {
    const vertices = new J.VertexList();
    const triangles = new J.IndexedTriangleList();
    vertices.resize(mesh.positions.length / 3);
    triangles.resize(mesh.corners.length / 3);
    for (let k = 0; k < mesh.positions.length / 3; ++k) {
        const vertex = vertices.at(k);
        [vertex.x, vertex.y, vertex.z] = mesh.positions.subarray(3 * k, 3 * k + 3);
    }
    for (let k = 0; k < mesh.corners.length / 3; ++k)
        for (let corner = 0; corner < 3; ++corner) triangles.at(k).set_mIdx(corner, mesh.corners[3 * k + corner]);
    const result = new J.MeshShapeSettings(vertices, triangles, new J.PhysicsMaterialList()).Create();
    if (result.HasError()) throw new Error(result.GetError().c_str());
    const shape = result.Get();
    shape.AddRef();
    return shape;
}

/** Its centre of mass is the origin. */
function joltShape(J, { spheres, half }, boxes) {
    if (boxes && half) return new J.BoxShape(new J.Vec3(...half), 0.02);
    const settings = new J.StaticCompoundShapeSettings();
    for (let k = 0; k < spheres.length; k += 4)
        settings.AddShapeShape(new J.Vec3(...spheres.subarray(k, k + 3)), new J.Quat(0, 0, 0, 1), new J.SphereShape(spheres[k + 3]), 0);
    const result = settings.Create();
    if (result.HasError()) throw new Error(result.GetError().c_str());
    const compound = result.Get();
    const middle = compound.GetCenterOfMass();
    return new J.OffsetCenterOfMassShape(compound, new J.Vec3(-middle.GetX(), -middle.GetY(), -middle.GetZ()));
}

/** A level as a body that stands. */
export function joltLevel(J, system, mesh) {
    const settings = new J.BodyCreationSettings(joltMeshShape(J, mesh), new J.RVec3(0, 0, 0), new J.Quat(0, 0, 0, 1), J.EMotionType_Static, STILL);
    settings.mFriction = FRICTION;
    settings.mEnhancedInternalEdgeRemoval = true;
    const bodies = system.GetBodyInterface();
    bodies.AddBody(bodies.CreateBody(settings).GetID(), J.EActivation_DontActivate);
}

export async function joltBodies(boxes) {
    const J = await initJolt();
    let jolt, bodies;
    return {
        name: boxes ? 'jolt-physics, boxes' : 'jolt-physics',
        start(scene) {
            jolt = joltWorld(J);
            const system = jolt.GetPhysicsSystem();
            const all = system.GetBodyInterface();
            joltLevel(J, system, scene.level.mesh);
            system.OptimizeBroadPhase();
            bodies = scene.bodies.map((one) => {
                const { mass, inertia, friction, restitution, position, rotation, velocity, spin } = one;
                const settings = new J.BodyCreationSettings(joltShape(J, one, boxes), new J.RVec3(...position), new J.Quat(...rotation), J.EMotionType_Dynamic, MOVING);
                settings.mFriction = friction;
                settings.mRestitution = restitution;
                settings.mMotionQuality = J.EMotionQuality_LinearCast;
                settings.mEnhancedInternalEdgeRemoval = true;
                settings.mMaxLinearVelocity = 1000;
                settings.mOverrideMassProperties = J.EOverrideMassProperties_MassAndInertiaProvided;
                settings.mMassPropertiesOverride.mMass = mass;
                settings.mMassPropertiesOverride.mInertia = J.Mat44.prototype.sScaleVec3(new J.Vec3(...inertia));
                const body = all.CreateBody(settings);
                J.destroy(settings);
                all.AddBody(body.GetID(), J.EActivation_Activate);
                body.SetLinearVelocity(new J.Vec3(...velocity));
                body.SetAngularVelocity(new J.Vec3(...spin));
                return body;
            });
        },
        step: () => jolt.Step(TICK, 1),
        read({ numbers, asleep }) {
            bodies.forEach((body, k) => {
                const at = body.GetCenterOfMassPosition();
                numbers.set([at.GetX(), at.GetY(), at.GetZ()], NUMBERS * k);
                const q = body.GetRotation();
                numbers.set([q.GetX(), q.GetY(), q.GetZ(), q.GetW()], NUMBERS * k + 3);
                const v = body.GetLinearVelocity();
                numbers.set([v.GetX(), v.GetY(), v.GetZ()], NUMBERS * k + 7);
                const w = body.GetAngularVelocity();
                numbers.set([w.GetX(), w.GetY(), w.GetZ()], NUMBERS * k + 10);
                asleep[k] = !body.IsActive();
            });
        },
        finish: () => J.destroy(jolt),
    };
}

function rapierColliders({ spheres, half }, boxes) {
    const { ColliderDesc } = Rapier;
    if (boxes && half) return [ColliderDesc.cuboid(...half)];
    const all = [];
    for (let k = 0; k < spheres.length; k += 4)
        all.push(ColliderDesc.ball(spheres[k + 3]).setTranslation(spheres[k], spheres[k + 1], spheres[k + 2]));
    return all;
}

export async function rapierBodies(boxes) {
    await Rapier.init();
    let world, bodies;
    return {
        name: boxes ? 'rapier3d, boxes' : 'rapier3d',
        start(scene) {
            world = new Rapier.World({ x: 0, y: 0, z: -9.81 });
            world.timestep = TICK;
            const level = Rapier.ColliderDesc.trimesh(Float32Array.from(scene.level.mesh.positions), scene.level.mesh.corners, Rapier.TriMeshFlags.FIX_INTERNAL_EDGES);
            world.createCollider(level.setFriction(FRICTION).setRestitution(0));
            bodies = scene.bodies.map((one) => {
                const { mass, inertia, friction, restitution, position, rotation, velocity, spin } = one;
                const [x, y, z, w] = rotation;
                const settings = Rapier.RigidBodyDesc.dynamic()
                    .setTranslation(...position)
                    .setRotation({ x, y, z, w })
                    .setLinvel(...velocity)
                    .setAngvel({ x: spin[0], y: spin[1], z: spin[2] })
                    .setCcdEnabled(true)
                    .setAdditionalMassProperties(
                        mass,
                        { x: 0, y: 0, z: 0 },
                        { x: inertia[0], y: inertia[1], z: inertia[2] },
                        { x: 0, y: 0, z: 0, w: 1 },
                    );
                const body = world.createRigidBody(settings);
                for (const collider of rapierColliders(one, boxes))
                    world.createCollider(
                        collider.setDensity(0).setFriction(friction).setRestitution(restitution).setRestitutionCombineRule(Rapier.CoefficientCombineRule.Max),
                        body,
                    );
                return body;
            });
        },
        step: () => world.step(),
        read({ numbers, asleep }) {
            bodies.forEach((body, k) => {
                const [at, q, v, w] = [body.worldCom(), body.rotation(), body.linvel(), body.angvel()];
                numbers.set([at.x, at.y, at.z, q.x, q.y, q.z, q.w, v.x, v.y, v.z, w.x, w.y, w.z], NUMBERS * k);
                asleep[k] = body.isSleeping();
            });
        },
        finish: () => world.free(),
    };
}
