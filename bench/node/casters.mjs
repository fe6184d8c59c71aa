// SPDX-License-Identifier: MIT
// Who casts: each makes its world of a mesh and answers with fractions; every answer's normal is read too.
//
// A caster is { name, buildMs, balls(inputs, fractions), rays(inputs, fractions) }; inputs are seven numbers a cast (start,
// radius, path), a miss has the fraction 2. `radius` is that of all balls.
import Rapier from '@dimforge/rapier3d-simd-compat';
import initJolt from 'jolt-physics/wasm-compat';
import { clock } from './race.mjs';

export const MISS = 2;

/** So that nothing of an answer can be left out. */
export const sink = { sum: 0 };

function timed(make) {
    const before = clock();
    const made = make();
    return { made, buildMs: clock() - before };
}

export function firmaSingle(world, buildMs) {
    const input = { centre: [0, 0, 0], radius: 0, path: [0, 0, 0] };
    const cast = (inputs, fractions) => {
        for (let k = 0, at = 0; k < fractions.length; ++k, at += 7) {
            for (let axis = 0; axis < 3; ++axis) {
                input.centre[axis] = inputs[at + axis];
                input.path[axis] = inputs[at + 4 + axis];
            }
            input.radius = inputs[at + 3];
            const hit = world.cast(input);
            fractions[k] = hit.status === 'miss' ? MISS : hit.fraction;
            sink.sum += hit.normal[2];
        }
    };
    return { name: 'Firma, one by one', buildMs, balls: cast, rays: cast };
}

export function firmaBatch(world, buildMs) {
    let answers;
    const cast = (inputs, fractions) => {
        answers = world.castBatch(inputs, undefined, answers);
        for (let k = 0; k < fractions.length; ++k) {
            fractions[k] = answers.status[k] === 0 ? MISS : answers.fraction[k];
            sink.sum += answers.normal[3 * k + 2];
        }
    };
    return { name: 'Firma, batch', buildMs, balls: cast, rays: cast };
}

function joltMesh(J, mesh) {
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
    const settings = new J.MeshShapeSettings(vertices, triangles, new J.PhysicsMaterialList());
    return timed(() => {
        const result = settings.Create();
        if (result.HasError()) throw new Error(result.GetError().c_str());
        const shape = result.Get();
        shape.AddRef();
        return shape;
    });
}

/** One static body in a world of one layer; its TransformedShape is what casts ask. One made with `new` would be empty. */
function joltBody(J, shape) {
    const settings = new J.JoltSettings();
    const pairs = new J.ObjectLayerPairFilterTable(1);
    pairs.EnableCollision(0, 0);
    const layers = new J.BroadPhaseLayerInterfaceTable(1, 1);
    layers.MapObjectToBroadPhaseLayer(0, new J.BroadPhaseLayer(0));
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
    const bodies = new J.JoltInterface(settings).GetPhysicsSystem().GetBodyInterface();
    const [still, unturned] = [new J.RVec3(0, 0, 0), new J.Quat(0, 0, 0, 1)];
    return bodies.CreateBody(new J.BodyCreationSettings(shape, still, unturned, J.EMotionType_Static, 0));
}

export async function jolt(mesh, radius) {
    const J = await initJolt();
    const { made: shape, buildMs } = joltMesh(J, mesh);
    const target = joltBody(J, shape).GetTransformedShape();
    const sphere = new J.SphereShape(radius);
    sphere.AddRef();
    // Jolt's objects are not collected: these live as long as the program.
    const [one, path, origin, start] = [new J.Vec3(1, 1, 1), new J.Vec3(0, 0, 0), new J.RVec3(0, 0, 0), new J.RVec3(0, 0, 0)];
    const [shapeSettings, raySettings] = [new J.ShapeCastSettings(), new J.RayCastSettings()];
    const [shapeHit, rayHit] = [new J.CastShapeClosestHitCollisionCollector(), new J.CastRayClosestHitCollisionCollector()];
    const filter = new J.ShapeFilter();
    const ray = new J.RRayCast(start, path);
    const balls = (inputs, fractions) => {
        for (let k = 0, at = 0; k < fractions.length; ++k, at += 7) {
            start.Set(inputs[at], inputs[at + 1], inputs[at + 2]);
            path.Set(inputs[at + 4], inputs[at + 5], inputs[at + 6]);
            // Keeps the box of its path, so each cast needs one of its own.
            const cast = new J.RShapeCast(sphere, one, J.RMat44.prototype.sTranslation(start), path);
            shapeHit.Reset();
            target.CastShape(cast, shapeSettings, origin, shapeHit, filter);
            J.destroy(cast);
            const met = shapeHit.HadHit();
            fractions[k] = met ? shapeHit.mHit.mFraction : MISS;
            if (met) sink.sum += shapeHit.mHit.mPenetrationAxis.GetZ();
        }
    };
    const rays = (inputs, fractions) => {
        for (let k = 0, at = 0; k < fractions.length; ++k, at += 7) {
            ray.mOrigin.Set(inputs[at], inputs[at + 1], inputs[at + 2]);
            ray.mDirection.Set(inputs[at + 4], inputs[at + 5], inputs[at + 6]);
            rayHit.Reset();
            target.CastRay(ray, raySettings, rayHit, filter);
            const met = rayHit.HadHit();
            fractions[k] = met ? rayHit.mHit.mFraction : MISS;
            if (!met) continue;
            const normal = target.GetWorldSpaceSurfaceNormal(rayHit.mHit.mSubShapeID2, ray.GetPointOnRay(fractions[k]));
            sink.sum += normal.GetZ();
        }
    };
    return { name: 'jolt-physics', buildMs, balls, rays };
}

export async function rapier(mesh, radius) {
    await Rapier.init();
    const world = new Rapier.World({ x: 0, y: 0, z: 0 });
    const positions = Float32Array.from(mesh.positions);
    const { made: collider, buildMs } = timed(() => world.createCollider(Rapier.ColliderDesc.trimesh(positions, mesh.corners)));
    world.step();
    const ball = new Rapier.Ball(radius);
    const [still, start, path, unturned] = [{ x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 0, w: 1 }];
    const ray = new Rapier.Ray(start, path);
    const set = (inputs, at) => {
        [start.x, start.y, start.z] = [inputs[at], inputs[at + 1], inputs[at + 2]];
        [path.x, path.y, path.z] = [inputs[at + 4], inputs[at + 5], inputs[at + 6]];
    };
    const balls = (inputs, fractions) => {
        for (let k = 0, at = 0; k < fractions.length; ++k, at += 7) {
            set(inputs, at);
            const hit = collider.castShape(still, ball, start, unturned, path, 0, 1, true);
            fractions[k] = hit ? hit.time_of_impact : MISS;
            if (hit) sink.sum += hit.normal1.z;
        }
    };
    const rays = (inputs, fractions) => {
        for (let k = 0, at = 0; k < fractions.length; ++k, at += 7) {
            set(inputs, at);
            const hit = collider.castRayAndGetNormal(ray, 1, true);
            fractions[k] = hit ? hit.timeOfImpact : MISS;
            if (hit) sink.sum += hit.normal.z;
        }
    };
    return { name: 'rapier3d-simd-compat', buildMs, balls, rays };
}
