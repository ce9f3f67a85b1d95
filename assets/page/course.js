// What the embedded course says of a minute: shares of the deformation, offsets of the arm, errors of the targets.

const ZERO = [0, 0, 0];

export class Course {
  constructor(view) {
    const { course, points } = view;
    this.t = course.t;
    this.shares = course.shares;
    this.offsets = course.offsets;
    this.hasModel = course.has_model;
    this.model = view.model ?? null;
    this.from = course.from_c ?? 0;
    this.byTemperature = course.from_c !== null && course.from_c !== undefined;
    this.unit = this.byTemperature ? '°C' : 'min';
    this.end = this.t[this.t.length - 1];
    this.points = points;
    this.count = points.motion.length;
    this.nodes = this.shares.length;
  }

  /** For each node the share of it that is there at minute `t`. */
  at(t) {
    const last = this.t.length - 1;
    const place = Math.min(Math.max((t / this.end) * last, 0), last);
    const low = Math.min(Math.floor(place), last - 1);
    const part = place - low;
    return this.shares.map((share) => share[low] + (share[low + 1] - share[low]) * part);
  }

  /** Whether the deformation of the arm is known at the targets alone, as it differs from one to the other. */
  get isByTarget() {
    return this.model !== null && this.model.still.columns.length + this.model.moving.columns.length > 0;
  }

  /** How the arm deforms at target `i` and minute `t`: turns of the joints, deg, and rows of offsets, mm and deg. */
  deviation(i, t) {
    const shares = this.at(t);
    if (!this.model) return { turns: null, offsets: this.offsets[0].map((row, j) => row.map((_, k) => shares.reduce((sum, share, n) => sum + share * this.offsets[n][j][k], 0))) };
    const { common, still, moving } = this.model;
    const all = common[0].map((_, c) => shares.reduce((sum, share, n) => sum + share * common[n][c], 0));
    const { length: a } = still.columns;
    still.columns.forEach((c, k) => { all[c] = still.values[i * a + k]; });
    const { length: b } = moving.columns;
    moving.columns.forEach((c, k) => { all[c] = shares.reduce((sum, share, n) => sum + share * moving.values[(i * this.nodes + n) * b + k], 0); });
    return { turns: all.slice(0, 6), offsets: Array.from({ length: 7 }, (_, j) => all.slice(6 + 6 * j, 12 + 6 * j)) };
  }

  /** Where a target is displaced to by `shares`, mm; into `out` from `at` on. */
  error(i, shares, out = [0, 0, 0], at = 0) {
    const { e_mm } = this.points;
    for (let k = 0; k < 3; k += 1) {
      let sum = 0;
      for (let n = 0; n < this.nodes; n += 1) sum += shares[n] * e_mm[(i * this.nodes + n) * 3 + k];
      out[at + k] = sum;
    }
    return out;
  }

  position(i) {
    return this.points.p_mm.slice(3 * i, 3 * i + 3);
  }

  joints(i) {
    return this.points.q_deg.slice(6 * i, 6 * i + 6);
  }

  tool(i) {
    return this.points.tools[this.points.tool[i]] ?? ZERO;
  }
}

/** What the corrected program makes of a drift: which bucket is in use, and what is left of each error. */
export class Correction {
  constructor(course, data) {
    this.course = course;
    this.buckets = data.buckets.map((bucket) => ({ ...bucket, shares: course.at(bucket.at_min) }));
    this.left = data.worst_after_mm;
  }

  get inBuckets() {
    return this.buckets.length > 0;
  }

  bucketAt(t) {
    return this.buckets.find((bucket) => bucket.to_min === null || t < bucket.to_min) ?? null;
  }

  /** The shares that are not corrected at minute `t`: zero where a motion follows the drift itself. */
  leftShares(t) {
    const now = this.course.at(t);
    const bucket = this.bucketAt(t);
    return bucket ? now.map((share, k) => share - bucket.shares[k]) : now.map(() => 0);
  }

  /** What is taken off at minute `t`. */
  correctedShares(t) {
    return this.bucketAt(t)?.shares ?? this.course.at(t);
  }
}

export const length = ([x, y, z]) => Math.hypot(x, y, z);

/** The worst error of all targets at each of `minutes`, before and after, mm. */
export function worstCurves(course, correction, minutes) {
  const sizes = largest(course);
  const worst = (shares) => {
    if (course.nodes === 1) return Math.abs(shares[0]) * sizes[0];
    let most = 0;
    const e = [0, 0, 0];
    for (let i = 0; i < course.count; i += 1) {
      course.error(i, shares, e);
      most = Math.max(most, e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
    }
    return Math.sqrt(most);
  };
  return {
    before: minutes.map((t) => worst(course.at(t))),
    after: correction.inBuckets ? minutes.map((t) => worst(correction.leftShares(t))) : null,
  };
}

function largest(course) {
  const most = new Array(course.nodes).fill(0);
  for (let i = 0; i < course.count; i += 1) {
    for (let n = 0; n < course.nodes; n += 1) {
      const at = (i * course.nodes + n) * 3;
      most[n] = Math.max(most[n], length(course.points.e_mm.slice(at, at + 3)));
    }
  }
  return most;
}
