// What `rotatebook export` wrote, as three.js and glTF Transform play it, beside the motion's table, and glTF's
// validator. The environment has READERS_CASES, the folder of cases.json that `run` leaves.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import test from "node:test";
import {NodeIO} from "@gltf-transform/core";
import validator from "gltf-validator";
import * as THREE from "three";
import {GLTFLoader} from "three/addons/loaders/GLTFLoader.js";
import {USDLoader} from "three/addons/loaders/USDLoader.js";

const folder = process.env.READERS_CASES;
const cases = JSON.parse(fs.readFileSync(path.join(folder, "cases.json")));
const kClose = 0.05 * Math.PI / 180;  // As seen from the centre of the body.
const kEach = 150;  // Of so many vertices one is looked at.

// Pictures aren't decoded.
globalThis.document = {createElementNS: () => ({addEventListener() {}, removeEventListener() {}})};

/** Returns rows of {time, corners} at all frames up to the last key. */
function tableOf({csv, rate}, last) {
  const [head, ...rows] = fs.readFileSync(path.join(folder, csv), "utf8").trim().split("\n").map((line) => line.split(","));
  const first = head.indexOf("c0x");
  const read = rows.map((row) => ({time: row[0] / rate, corners: row.slice(first, first + 24).map(Number)}));
  return read.filter(({time}) => time <= last);
}

/** Returns where a vertex of the body at rest is, in the cage of corners. */
function placed(rest, size, corners) {
  const at = new THREE.Vector3();
  for (let i = 0; i < 8; ++i) {
    let weight = 1;
    for (let axis = 0; axis < 3; ++axis) {
      const u = rest.getComponent(axis) / size[axis] + 0.5;
      weight *= i >> axis & 1 ? u : 1 - u;
    }
    at.add(new THREE.Vector3(...corners.slice(3 * i)).multiplyScalar(weight));
  }
  return at;
}

/** Compares all frames: `vertices` are at rest, `shown(time)` returns where they are. */
function compare(scene, last, vertices, shown) {
  const table = tableOf(scene, last);
  assert.ok(table.length >= 1000, `${table.length} frames`);
  const size = [0, 1, 2].map((axis) => table[0].corners[21 + axis] - table[0].corners[axis]);
  let largest = 0, moved = 0;
  for (const {time, corners} of table) {
    shown(time).forEach((at, i) => {
      largest = Math.max(largest, at.distanceTo(placed(vertices[i], size, corners)));
      moved = Math.max(moved, at.distanceTo(vertices[i]));
    });
  }
  const radius = Math.hypot(...size) / 2;
  console.log(`${scene.name}: ${table.length} frames, ${(largest / radius * 180 / Math.PI).toFixed(4)} degrees`);
  assert.ok(moved > radius / 2);
  assert.ok(largest < kClose * radius, `${largest} m`);
}

/** Returns where a vertex of the body at rest is: all morphs at half their weight. */
function atRest(position, targets) {
  return targets.reduce((sum, target) => sum.addScaledVector(target, 0.5), position);
}

const vertexOf = (attribute, i) => new THREE.Vector3().fromBufferAttribute(attribute, i);

/** Compares what three.js shows of an animated object. */
function compareThree(scene, root, clip) {
  const mixer = new THREE.AnimationMixer(root);
  mixer.clipAction(clip).setLoop(THREE.LoopOnce).play();
  mixer.clipAction(clip).clampWhenFinished = true;
  const meshes = [], places = [], vertices = [];
  root.traverse((object) => object.isMesh && meshes.push(object));
  for (const mesh of meshes) {
    const position = mesh.geometry.attributes.position;
    for (let i = 0; i < position.count; i += kEach) {
      places.push({mesh, i});
      const targets = mesh.geometry.morphAttributes.position ?? [];
      vertices.push(atRest(vertexOf(position, i), targets.map((target) => vertexOf(target, i))));
    }
  }
  compare(scene, clip.duration, vertices, (time) => {
    mixer.setTime(time);
    root.updateMatrixWorld(true);
    return places.map(({mesh, i}) => mesh.localToWorld(mesh.getVertexPosition(i, new THREE.Vector3())));
  });
}

const bytesOf = (file) => new Uint8Array(fs.readFileSync(path.join(folder, file)));

for (const scene of cases) {
  test(`${scene.name}: the validator finds nothing`, async () => {
    const {issues} = await validator.validateBytes(bytesOf(scene.glb));
    assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], JSON.stringify(issues.messages));
  });

  test(`${scene.name}: three.js plays the GLB`, async () => {
    const loader = new GLTFLoader();
    loader.register(() => ({name: "no pictures", loadTexture: async () => new THREE.Texture()}));
    const gltf = await loader.parseAsync(bytesOf(scene.glb).buffer, "");
    compareThree(scene, gltf.scene, gltf.animations[0]);
  });

  test(`${scene.name}: glTF Transform reads the GLB`, async () => {
    const root = (await new NodeIO().readBinary(bytesOf(scene.glb))).getRoot();
    const channels = root.listAnimations()[0].listChannels();
    const samplerOf = (name) => channels.find((channel) => channel.getTargetPath() === name)?.getSampler();
    const turning = samplerOf("rotation"), morphing = samplerOf("weights");
    const times = turning.getInput().getArray(), last = times[times.length - 1];
    const keyAt = (time) => {
      const a = Math.min(times.findLastIndex((key) => key <= time), times.length - 2);
      return {a, share: (time - times[a]) / (times[a + 1] - times[a])};
    };
    const bases = [], targets = [];
    for (const primitive of root.listMeshes()[0].listPrimitives()) {
      const position = primitive.getAttribute("POSITION");
      for (let i = 0; i < position.getCount(); i += kEach) {
        bases.push(new THREE.Vector3(...position.getElement(i, [])));
        targets.push(primitive.listTargets().map((target) => new THREE.Vector3(...target.getAttribute("POSITION").getElement(i, []))));
      }
    }
    const vertices = bases.map((base, i) => atRest(base.clone(), targets[i]));
    compare(scene, last, vertices, (time) => {
      const {a, share} = keyAt(time);
      const [from, to] = [a, a + 1].map((key) => new THREE.Quaternion(...turning.getOutput().getElement(key, [])));
      const values = morphing?.getOutput().getArray();
      const attitude = from.slerp(to, share);
      return bases.map((base, i) => {
        const at = base.clone();
        targets[i].forEach((target, k) => at.addScaledVector(target, (1 - share) * values[24 * a + k] + share * values[24 * a + 24 + k]));
        return at.applyQuaternion(attitude);
      });
    });
  });

  if (!scene.usdz) continue;
  test(`${scene.name}: three.js plays the USDZ`, () => {
    const file = bytesOf(scene.usdz);
    const root = new USDLoader().parse(file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength));
    compareThree(scene, root, root.animations[0]);
  });
}
