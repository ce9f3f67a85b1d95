// A 3-D view that is drawn only when something has changed: camera, light, floor, picking. Knows nothing of arms.

import {
  Color, DirectionalLight, GridHelper, HemisphereLight, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { h, oncePerFrame } from './dom.js';
import { colour, onTheme } from './theme.js';

const FLOOR_MM = 2000;

export class View3D {
  /** `label` is what a reader who does not see the picture is told; where there is `much` to draw, edges stay rough. */
  constructor(label, much) {
    this.canvas = h('canvas', { tabIndex: 0, role: 'img', 'aria-label': label });
    this.element = h('div', { class: 'view3d' }, this.canvas);
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: !much, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, much ? 1 : 2));
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(35, 1, 10, 60000);
    this.camera.up.set(0, 0, 1);
    this.sky = new HemisphereLight(0xffffff, 0x666666, 2.2);
    this.sky.position.set(0, 0, 1);
    this.sun = new DirectionalLight(0xffffff, 1.6);
    this.sun.position.set(1500, -2500, 4000);
    this.scene.add(this.sky, this.sun);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.listenToKeyEvents(this.canvas);
    this.controls.addEventListener('change', () => this.redraw());
    this.canvas.addEventListener('keydown', (event) => this.zoomByKey(event));
    this.pending = new Set();
    this.redraw = oncePerFrame(() => this.draw());
    this.themed = [];
    onTheme(() => this.dress());
    new ResizeObserver(() => this.resize()).observe(this.element);
    this.dress();
  }

  /** Calls `paint` now and whenever the colours change. */
  dressed(paint) {
    this.themed.push(paint);
    paint();
    this.redraw();
  }

  dress() {
    this.scene.background = new Color(colour('stage'));
    if (this.floor) this.scene.remove(this.floor);
    this.floor = new GridHelper(FLOOR_MM, 20, colour('grid-strong'), colour('grid'));
    this.floor.rotation.x = Math.PI / 2;
    this.scene.add(this.floor);
    this.themed.forEach((paint) => paint());
    this.redraw();
  }

  /** Looks at a box from in front, from the right and from above. */
  lookAt(low, high) {
    const centre = new Vector3((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2);
    this.radius = Math.max(Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2, 50);
    this.centre = centre;
    this.home();
  }

  home() {
    const { aspect } = this.camera;
    const angle = (this.camera.fov * Math.PI) / 360;
    const distance = (this.radius / Math.sin(angle)) * (aspect < 1 ? 1 / aspect : 1) * 0.82;
    this.controls.target.copy(this.centre);
    this.camera.position.copy(this.centre).add(new Vector3(0.72, -0.95, 0.5).normalize().multiplyScalar(distance));
    this.controls.update();
    this.redraw();
  }

  zoomByKey(event) {
    const factor = { '+': 0.87, '=': 0.87, '-': 1.15 }[event.key];
    if (event.key === 'Home') this.home();
    if (!factor) return;
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    event.preventDefault();
  }

  resize() {
    const { clientWidth, clientHeight } = this.element;
    if (clientWidth === 0 || clientHeight === 0) return;
    const first = this.camera.aspect === 1;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    if (first && this.centre) this.home();
    this.draw();
  }

  /** A function that has `work` done once before the next picture, however often it is called. */
  beforePicture(work) {
    return () => {
      this.pending.add(work);
      this.redraw();
    };
  }

  draw() {
    this.pending.forEach((work) => work());
    this.pending.clear();
    this.renderer.render(this.scene, this.camera);
  }

  /** Calls `picked` with the index of the point of `points()` that is clicked on, or null. */
  onPick(points, picked) {
    let down = null;
    this.canvas.addEventListener('pointerdown', (event) => { down = [event.clientX, event.clientY]; });
    this.canvas.addEventListener('pointerup', (event) => {
      if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
      const box = this.canvas.getBoundingClientRect();
      const at = new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
      const ray = new Raycaster();
      // about nine pixels at the distance that is looked at
      const distance = this.camera.position.distanceTo(this.controls.target);
      ray.params.Points.threshold = (9 / box.height) * 2 * distance * Math.tan((this.camera.fov * Math.PI) / 360);
      ray.setFromCamera(at, this.camera);
      const [hit] = ray.intersectObject(points()).sort((a, b) => a.distanceToRay - b.distanceToRay);
      if (hit) picked(hit.index);
    });
  }

  /** Where a place in the base stands in the window, pixels. */
  toWindow([x, y, z]) {
    const seen = new Vector3(x, y, z).project(this.camera);
    const box = this.canvas.getBoundingClientRect();
    return [box.left + ((seen.x + 1) / 2) * box.width, box.top + ((1 - seen.y) / 2) * box.height];
  }
}

/** A view, or what is said where the browser draws no 3-D. */
export function view3d(label, much = false) {
  try {
    return new View3D(label, much);
  } catch {
    return null;
  }
}
