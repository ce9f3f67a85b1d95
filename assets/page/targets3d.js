// Targets as dots, their path as a line, their errors as colours and arrows.

import {
  BufferGeometry, CanvasTexture, Float32BufferAttribute, Group, Line, LineBasicMaterial, LineSegments, Points, PointsMaterial,
} from 'three';
import { h } from './dom.js';
import { scale } from './theme.js';

const HEAD = 0.28;
/** Of more targets than this every second, third ... has an arrow: all of them would be a fog. */
const MOST_ARROWS = 1500;
const MOST_ROUND = 4000;

function dot() {
  const canvas = h('canvas', { width: 64, height: 64 });
  const pen = canvas.getContext('2d');
  pen.fillStyle = '#fff';
  pen.beginPath();
  pen.arc(32, 32, 30, 0, 2 * Math.PI);
  pen.fill();
  return new CanvasTexture(canvas);
}

const floats = (count) => new Float32BufferAttribute(new Float32Array(count), 3);

export class TargetCloud {
  /** `places` are three numbers for each target, mm. */
  constructor(places) {
    this.places = places;
    this.count = places.length / 3;
    this.group = new Group();
    const texture = dot();
    // Thousands of round dots take a browser without a graphics card half of its time: there they are small squares.
    const round = this.count > MOST_ROUND ? { size: 3 } : { size: this.count > 2000 ? 5 : 9, map: texture, alphaTest: 0.5 };
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute('position', new Float32BufferAttribute(places, 3));
    this.geometry.setAttribute('color', floats(3 * this.count));
    this.dots = new Points(this.geometry, new PointsMaterial({ vertexColors: true, sizeAttenuation: false, ...round }));
    this.path = new Line(this.geometry, new LineBasicMaterial({ transparent: this.count <= 2000, opacity: 0.55 }));
    // stem and two strokes of a head each
    this.step = Math.max(Math.ceil(this.count / MOST_ARROWS), 1);
    const arrows = Math.ceil(this.count / this.step);
    this.arrows = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true }));
    this.arrows.geometry.setAttribute('position', floats(18 * arrows));
    this.arrows.geometry.setAttribute('color', floats(18 * arrows));
    this.ring = new Points(new BufferGeometry(), new PointsMaterial({ size: 17, map: texture, alphaTest: 0.5, sizeAttenuation: false, depthTest: false, transparent: true, opacity: 0.45 }));
    this.ring.geometry.setAttribute('position', floats(3));
    this.ring.visible = false;
    for (const part of [this.path, this.arrows, this.ring, this.dots]) {
      part.frustumCulled = false;
      this.group.add(part);
    }
  }

  paint({ path, ring }) {
    this.path.material.color.set(path);
    this.ring.material.color.set(ring);
  }

  /** Marks one of them, or none. */
  mark(i) {
    this.ring.visible = i !== null;
    if (i === null) return;
    this.ring.geometry.attributes.position.setXYZ(0, ...this.places.slice(3 * i, 3 * i + 3));
    this.ring.geometry.attributes.position.needsUpdate = true;
  }

  /** Shows errors: `error(i, out)` gives one in mm, drawn `times` times as long, coloured as a share of `most`. */
  show(error, times, most) {
    const colours = this.geometry.attributes.color.array;
    const ends = this.arrows.geometry.attributes.position.array;
    const tints = this.arrows.geometry.attributes.color.array;
    const mix = scale();
    const e = [0, 0, 0];
    for (let i = 0; i < this.count; i += 1) {
      error(i, e);
      mix(Math.hypot(e[0], e[1], e[2]) / most, colours, 3 * i);
      if (i % this.step !== 0) continue;
      const at = 18 * (i / this.step);
      this.arrow(ends, at, 3 * i, e, times);
      for (let k = 0; k < 18; k += 1) tints[at + k] = colours[3 * i + (k % 3)];
    }
    this.geometry.attributes.color.needsUpdate = true;
    this.arrows.geometry.attributes.position.needsUpdate = true;
    this.arrows.geometry.attributes.color.needsUpdate = true;
  }

  arrow(ends, at, from, [x, y, z], times) {
    const p = this.places;
    const tip = [p[from] + x * times, p[from + 1] + y * times, p[from + 2] + z * times];
    // any direction across the arrow will do for its head
    const across = Math.abs(z) > Math.hypot(x, y) ? [z, 0, -x] : [-y, x, 0];
    for (let k = 0; k < 3; k += 1) {
      const along = [x, y, z][k] * times * HEAD;
      const side = across[k] * times * HEAD * 0.5;
      ends[at + k] = p[from + k];
      ends[at + 3 + k] = tip[k];
      ends[at + 6 + k] = tip[k];
      ends[at + 9 + k] = tip[k] - along + side;
      ends[at + 12 + k] = tip[k];
      ends[at + 15 + k] = tip[k] - along - side;
    }
  }
}
