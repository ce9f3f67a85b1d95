// The arm as a chain of links between its joints' frames: once as drawn, once as it is deformed.

import {
  BoxGeometry, BufferGeometry, CylinderGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial,
  Quaternion, SphereGeometry, Vector3,
} from 'three';
import { frames, identity, point } from './kinematics.js';

const UP = new Vector3(0, 1, 0);
const AXES = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const AXIS_MM = 70;

const origin = (m) => new Vector3(m[3], m[7], m[11]);

/** A round bar between two points; hidden where they are one. */
function stretch(mesh, from, to) {
  const along = to.clone().sub(from);
  const size = along.length();
  mesh.visible = size > 1;
  if (!mesh.visible) return;
  mesh.position.copy(from).addScaledVector(along, 0.5);
  mesh.quaternion.copy(new Quaternion().setFromUnitVectors(UP, along.normalize()));
  mesh.scale.set(1, size, 1);
}

export class ArmModel {
  /** `thickness` is a link's radius in mm. */
  constructor(arm, { thickness, transparent, opacity, axes }) {
    this.arm = arm;
    this.material = new MeshLambertMaterial({ transparent, opacity, depthWrite: !transparent });
    this.jointMaterial = new MeshLambertMaterial({ transparent, opacity, depthWrite: !transparent });
    this.group = new Group();
    const n = arm.joints.length;
    const bar = new CylinderGeometry(thickness, thickness, 1, 20);
    const hub = new CylinderGeometry(thickness * 1.45, thickness * 1.45, thickness * 3.2, 24);
    const rail = new BoxGeometry(thickness * 2.4, thickness * 5, thickness * 2.4);
    const knee = new SphereGeometry(thickness, 20, 14);
    const mesh = (geometry, material) => {
      const one = new Mesh(geometry, material);
      this.group.add(one);
      return one;
    };
    // base to joint 1, joint to joint, last joint to flange, flange to TCP
    this.bars = Array.from({ length: n + 2 }, () => mesh(bar, this.material));
    this.bars[n + 1].scale.setScalar(0.4);
    this.knees = Array.from({ length: n + 1 }, () => mesh(knee, this.material));
    // a joint that turns is a drum about its axis, one that slides a block along it
    this.hubs = arm.joints.map((joint) => mesh(joint.slides ? rail : hub, this.jointMaterial));
    if (axes) {
      const colours = AXES.flatMap((axis) => [...axis, ...axis].map((c) => 0.25 + 0.6 * c));
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new Float32BufferAttribute(new Float32Array((n + 1) * 18), 3));
      geometry.setAttribute('color', new Float32BufferAttribute(Array.from({ length: n + 1 }, () => colours).flat(), 3));
      this.lines = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true, depthTest: false }));
      this.lines.frustumCulled = false;
      this.group.add(this.lines);
    }
  }

  paint(link, joint) {
    this.material.color.set(link);
    this.jointMaterial.color.set(joint);
  }

  /** Poses it; gives where the TCP stands, mm. */
  pose(q, tool, deviation = {}, times = 1) {
    const all = frames(this.arm, q, deviation, times);
    const n = this.arm.joints.length;
    const tcp = point(all[n], tool);
    const places = [origin(identity()), ...all.map(origin), new Vector3(...tcp)];
    this.bars.forEach((bar, i) => stretch(bar, places[i], places[i + 1]));
    this.bars[n + 1].scale.x = 0.35;
    this.bars[n + 1].scale.z = 0.35;
    this.knees.forEach((knee, i) => knee.position.copy(places[i + 1]));
    this.hubs.forEach((hub, i) => {
      const m = all[i];
      const [x, y, z] = this.arm.joints[i].axis;
      const axis = new Vector3(m[0] * x + m[1] * y + m[2] * z, m[4] * x + m[5] * y + m[6] * z, m[8] * x + m[9] * y + m[10] * z);
      hub.position.copy(places[i + 1]);
      hub.quaternion.copy(new Quaternion().setFromUnitVectors(UP, axis));
    });
    if (this.lines) this.drawAxes(all);
    return tcp;
  }

  drawAxes(all) {
    const { position } = this.lines.geometry.attributes;
    all.forEach((m, i) => {
      AXES.forEach((axis, k) => {
        const end = point(m, axis.map((c) => c * AXIS_MM));
        position.setXYZ(i * 6 + k * 2, m[3], m[7], m[11]);
        position.setXYZ(i * 6 + k * 2 + 1, ...end);
      });
    });
    position.needsUpdate = true;
  }
}
