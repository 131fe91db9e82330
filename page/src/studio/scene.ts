// The machine in space, moving as a mode or an orbit does.

import {
  BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, Group, HemisphereLight, Line, LineBasicMaterial, LineLoop, Mesh, MeshLambertMaterial,
  PerspectiveCamera, Scene as World, Vector3, WebGLRenderer,
} from "three";
import { between, largest, mesh, moved, stationsOf, whirl } from "./solid";
import type { Frames, Scene, Shape } from "./types";

/** Largest displacement shown, as part of the radius of the machine. */
const SHOWN = 0.22;
/** Seconds of one whirl on the screen. */
const PERIOD = 1.6;
/** Seconds of one turn of a transient on the screen; of all of it at least and at most. */
const TURN = 0.6, SHORTEST = 6, LONGEST = 45;
/** Frames that are measured together, and how long one may take, ms. */
const MEASURED = 12, SLOW = 17.5;
/** Frames whose trace is seen. */
const TRAIL = 48;

interface Uniforms { turn: { value: Vector3 } }

export class SpaceView {
  private renderer: WebGLRenderer;
  /** Edges are smoothed; where that takes too long, a drawing that stands still has more pixels instead. */
  private smooth = true;
  private readonly world = new World();
  private readonly camera = new PerspectiveCamera(32, 1, 0.001, 1000);
  private readonly machine = new Group();
  private readonly orbits = new Group();
  private readonly uniforms: Uniforms = { turn: { value: new Vector3(1, 0, 0) } };
  private scene: Scene | null = null;
  private shape: Shape | null = null;
  private size = 1;
  private radius = 1;
  /** Radius of the sphere around the machine. */
  private ball = 1;
  private angle = { around: 0.7, up: 0.42, far: 1 };
  private phase = 0;
  /** Part of the frames that has been played, and the frame whose vertices are set. */
  private played = 0;
  private set = -1;
  private before = 0;
  private frame = 0;
  private coarse = 2;
  /** Frames measured, and how long they took, ms. */
  private counted = 0;
  private took = 0;
  /** Frames drawn, for a measurement. */
  frames = 0;
  playing = true;
  amplitude = 1;
  /** Called with the time of what is played, s. */
  at: (time: number) => void = () => {};

  constructor(private readonly host: HTMLElement) {
    this.renderer = this.canvas();
    const light = new DirectionalLight(0xffffff, 2.2);
    light.position.set(2, 3, 4);
    this.world.add(new HemisphereLight(0xffffff, 0x667080, 1.6), light, this.machine);
    new ResizeObserver(() => this.resize()).observe(host);
    new IntersectionObserver(e => { this.visible = e[0].isIntersecting; this.wake(); }).observe(host);
    this.steer();
    this.resize();
  }

  private visible = true;

  private canvas(): WebGLRenderer {
    const renderer = new WebGLRenderer({ antialias: this.smooth, alpha: true, powerPreference: "high-performance" });
    renderer.domElement.setAttribute("aria-hidden", "true");
    this.host.replaceChildren(renderer.domElement);
    return renderer;
  }

  /** Draws without smoothing of edges from now on. */
  private rough(): void {
    this.smooth = false;
    this.renderer.dispose();
    this.renderer = this.canvas();
    this.resize();
  }

  private colour(kind: string): Color {
    const of = (name: string, otherwise: string) => new Color(getComputedStyle(document.documentElement).getPropertyValue(name).trim() || otherwise);
    switch (kind) {
      case "shaft": return of("--solid-shaft", "#8b97a5");
      case "disc": return of("--solid-disc", "#5b86b5");
      case "housing": return of("--solid-housing", "#c08a50");
      case "bearing": return of("--solid-bearing", "#4f9f86");
      case "liquid": return of("--oil", "#e6b84d");
      case "ball": return of("--solid-ball", "#c4553a");
      default: return of("--solid-ground", "#9aa2ab");
    }
  }

  private material(kind: string): MeshLambertMaterial {
    const clear = kind === "housing" ? 0.55 : kind === "liquid" ? 0.85 : 1;
    const m = new MeshLambertMaterial({ color: this.colour(kind), side: DoubleSide, transparent: clear < 1, opacity: clear });
    // a liquid touches the walls of its cavity: the wall is seen
    if (kind === "liquid") Object.assign(m, { polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 8 });
    m.onBeforeCompile = shader => {
      shader.uniforms.turn = this.uniforms.turn;
      shader.vertexShader = shader.vertexShader
        .replace("#include <common>", "#include <common>\nattribute vec4 whirl;\nuniform vec3 turn;")
        .replace("#include <begin_vertex>", "#include <begin_vertex>\ntransformed.xy += turn.z * vec2(whirl.x * turn.x - whirl.y * turn.y, whirl.z * turn.x - whirl.w * turn.y);");
    };
    return m;
  }

  /** Another machine, or the same with other dimensions. */
  show(scene: Scene | null): void {
    this.scene = scene;
    for (const o of [...this.machine.children]) { this.machine.remove(o); if (o instanceof Mesh) { o.geometry.dispose(); (o.material as MeshLambertMaterial).dispose(); } }
    if (!scene) return this.wake();
    const all = scene.solids.flatMap(s => s.outline), zs = all.map(p => p[0]), rs = all.map(p => p[1]);
    const low = Math.min(...zs), high = Math.max(...zs);
    this.radius = Math.max(...rs, 1e-4);
    this.size = Math.max(high - low, 2 * this.radius);
    this.ball = Math.hypot((high - low) / 2, (1 + SHOWN) * this.radius);
    for (const s of scene.solids) {
      if (s.outline.length < 3) continue;
      const o = new Mesh(mesh(s, this.size), this.material(s.kind));
      o.name = s.body ?? "";
      o.frustumCulled = false;
      this.machine.add(o);
    }
    this.machine.add(this.orbits);
    // the axis of the machine points up, or lies
    this.machine.rotation.set(scene.axis === "vertical" ? -Math.PI / 2 : 0, scene.axis === "vertical" ? 0 : Math.PI / 2, 0);
    const middle = (low + high) / 2;
    this.machine.position.set(scene.axis === "vertical" ? 0 : -middle, scene.axis === "vertical" ? -middle : 0, 0);
    this.whirls(this.shape);
  }

  /** The motion shown; null is rest. */
  whirls(shape: Shape | null): void {
    this.shape = shape;
    this.set = -1;
    for (const o of [...this.orbits.children]) { this.orbits.remove(o); (o as Line).geometry.dispose(); }
    if (!shape?.frames) for (const o of this.solids()) whirl(o.geometry, shape ? stationsOf(shape, o.name || null) : []);
    const most = shape ? largest(shape) : 0;
    if (shape && most > 0) this.paths(shape, this.scale(most));
    this.wake();
  }

  private solids(): Mesh[] { return this.machine.children.filter(o => o instanceof Mesh); }

  /** From the beginning. */
  rewind(): void { this.played = 0; }

  /** Displacements on the screen over those of the machine. */
  get enlarged(): number { return this.shape ? this.scale(largest(this.shape)) : 0; }

  /** Seconds on the screen for one of the machine. */
  get slowed(): number {
    if (!this.shape) return 0;
    const end = this.shape.frames?.times.at(-1);
    return end ? this.seconds(this.shape) / end : PERIOD * this.shape.frequency / (2 * Math.PI);
  }

  /** Seconds of all frames on the screen. */
  private seconds(shape: Shape): number {
    const turns = shape.turns ?? 1;
    return shape.frames?.closed ? turns * PERIOD : Math.min(LONGEST, Math.max(SHORTEST, turns * TURN));
  }

  private scale(most: number): number { return most > 0 ? SHOWN * this.amplitude * this.radius / most : 0; }

  /** Orbits of a few points of each body. */
  private paths(shape: Shape, scale: number): void {
    const line = new LineBasicMaterial({ color: this.colour("ball"), depthTest: false, transparent: true, opacity: 0.9 });
    if (shape.frames) return this.traces(shape.frames, scale, line);
    for (const body of new Set(shape.stations.map(s => s.body))) {
      const own = stationsOf(shape, body), every = Math.max(1, Math.ceil(own.length / 7));
      own.filter((_, i) => i % every === 0 || i === own.length - 1).forEach(s => {
        const at = this.scene?.solids.find(q => q.body === body)?.at ?? [0, 0], m = moved(own, s.z), n = 60, place = new Float32Array(3 * n);
        for (let k = 0; k < n; k++) {
          const c = Math.cos(2 * Math.PI * k / n), d = Math.sin(2 * Math.PI * k / n);
          place.set([at[0] + scale * (m[0] * c - m[1] * d), at[1] + scale * (m[2] * c - m[3] * d), s.z], 3 * k);
        }
        const g = new BufferGeometry();
        g.setAttribute("position", new BufferAttribute(place, 3));
        const loop = new LineLoop(g, line);
        loop.frustumCulled = false;
        loop.renderOrder = 9;
        this.orbits.add(loop);
      });
    }
  }

  private traces(frames: Frames, scale: number, line: LineBasicMaterial): void {
    for (const body of new Set(frames.paths.map(p => p.body))) {
      const own = frames.paths.filter(p => p.body === body), every = Math.max(1, Math.ceil(own.length / 7)), at = this.scene?.solids.find(q => q.body === body)?.at ?? [0, 0];
      own.filter((_, i) => i % every === 0 || i === own.length - 1).forEach(p => {
        const g = new BufferGeometry();
        g.setAttribute("position", new BufferAttribute(new Float32Array(p.x.flatMap((x, k) => [at[0] + scale * x, at[1] + scale * p.y[k], p.z])), 3));
        const trace = new Line(g, line);
        trace.frustumCulled = false;
        trace.renderOrder = 9;
        this.orbits.add(trace);
      });
    }
  }

  /** Sets the vertices to the frames before and after the time that is reached; where it lies between them. */
  private frameAt(frames: Frames): number {
    const { times } = frames, t = this.played * (times.at(-1) ?? 0);
    let k = this.set >= 0 && times[this.set] <= t ? this.set : 0;
    while (k < times.length - 2 && times[k + 1] <= t) k++;
    if (k !== this.set) {
      for (const o of this.solids()) if (o.name) whirl(o.geometry, between(frames, o.name, k));
      this.set = k;
      // of a transient the last turns: all of them would hide each other
      const from = Math.max(0, k - TRAIL);
      if (!frames.closed) for (const o of this.orbits.children) (o as Line).geometry.setDrawRange(from, k + 2 - from);
    }
    this.at(t);
    const step = times[k + 1] - times[k];
    return step > 0 ? Math.min(1, Math.max(0, (t - times[k]) / step)) : 0;
  }

  /** Colours of another theme. */
  recolour(): void { const s = this.scene; if (s) this.show(s); }

  setAmplitude(a: number): void { this.amplitude = a; this.whirls(this.shape); }

  play(on: boolean): void { this.playing = on; this.before = 0; this.wake(); }

  /** Pixels of the drawing for one of the page: fewer while it moves, where the machine cannot draw all of them 60 times a second. */
  private sharpness(moves: boolean): void {
    const full = this.smooth ? Math.min(devicePixelRatio, 2) : 2, now = moves ? Math.min(devicePixelRatio, this.coarse) : full;
    if (now !== this.renderer.getPixelRatio()) this.renderer.setPixelRatio(now);
  }

  /** Measures a number of frames; where they took too long, the next ones are plainer. */
  private pace(t: number): void {
    if (!this.before || t - this.before > 500) { this.took = this.counted = 0; return; }
    this.took += t - this.before;
    if (++this.counted < MEASURED) return;
    if (this.took > MEASURED * SLOW) {
      if (this.smooth) this.rough();
      else this.coarse = Math.max(0.5, 0.8 * Math.min(this.coarse, devicePixelRatio));
    }
    this.took = this.counted = 0;
  }

  private resize(): void {
    const w = Math.max(this.host.clientWidth, 1), h = Math.max(this.host.clientHeight, 1);
    this.renderer.setSize(w, h, false);
    this.camera.aspect = w / h;
    this.camera.updateProjectionMatrix();
    this.wake();
  }

  /** Pointers turn, the wheel and two fingers move near and far; so do the keys. */
  private steer(): void {
    const host = this.host, on = new Map<number, PointerEvent>();
    const far = (k: number) => { this.angle.far = Math.min(3, Math.max(0.35, this.angle.far * k)); this.wake(); };
    const turn = (x: number, y: number) => {
      this.angle.around -= x;
      this.angle.up = Math.min(1.5, Math.max(-1.5, this.angle.up + y));
      this.wake();
    };
    const gap = () => { const [a, b] = [...on.values()]; return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY); };
    host.addEventListener("pointerdown", e => { on.set(e.pointerId, e); if (e.isTrusted) host.setPointerCapture(e.pointerId); });
    host.addEventListener("pointermove", e => {
      const last = on.get(e.pointerId);
      if (!last) return;
      const wide = on.size === 2 ? gap() : 0;
      on.set(e.pointerId, e);
      if (on.size === 2) far(wide / Math.max(gap(), 1));
      else turn((e.clientX - last.clientX) * 0.008, (e.clientY - last.clientY) * 0.008);
    });
    for (const end of ["pointerup", "pointercancel"] as const) host.addEventListener(end, e => on.delete(e.pointerId));
    host.addEventListener("wheel", e => { e.preventDefault(); far(Math.exp(e.deltaY * 0.001)); }, { passive: false });
    host.addEventListener("keydown", e => {
      const by: Record<string, () => void> = {
        ArrowLeft: () => turn(0.1, 0), ArrowRight: () => turn(-0.1, 0), ArrowUp: () => turn(0, -0.1), ArrowDown: () => turn(0, 0.1),
        "+": () => far(0.9), "-": () => far(1.1),
      };
      const act = by[e.key];
      if (act) { e.preventDefault(); act(); }
    });
  }

  private wake(): void { if (!this.frame && this.visible) this.frame = requestAnimationFrame(t => this.draw(t)); }

  private draw(t: number): void {
    this.frame = 0;
    const moves = this.playing && this.shape !== null;
    if (moves && this.before) {
      const passed = Math.min((t - this.before) / 1000, 0.1);
      this.phase += passed / PERIOD * 2 * Math.PI;
      if (this.shape?.frames) this.played = (this.played + passed / this.seconds(this.shape)) % 1;
    }
    if (moves) this.pace(t);
    this.before = moves ? t : 0;
    this.sharpness(moves);
    if (this.shape?.frames) {
      const part = this.frameAt(this.shape.frames);
      this.uniforms.turn.value.set(1 - part, -part, this.enlarged);
    } else this.uniforms.turn.value.set(Math.cos(this.phase), Math.sin(this.phase), this.enlarged);
    const { around, up, far } = this.angle, wide = Math.min(1, this.camera.aspect);
    const d = far * this.ball / Math.sin(this.camera.fov * Math.PI / 360) / wide;
    this.camera.position.set(d * Math.cos(up) * Math.sin(around), d * Math.sin(up), d * Math.cos(up) * Math.cos(around));
    this.camera.near = d / 100;
    this.camera.far = d * 10;
    this.camera.updateProjectionMatrix();
    this.camera.lookAt(0, 0, 0);
    this.renderer.render(this.world, this.camera);
    this.frames++;
    if (moves) this.wake();
  }
}

export const open = (host: HTMLElement): SpaceView => new SpaceView(host);
