// The constructive model: T_i = Trans(p_i + d) Rx Ry Rz R_i Rot(axis, q) or Trans(q axis), d, Rx, Ry, Rz as the deformation table says. Lengths mm, angles rad.
// Matrices are 12 numbers: three rows of a rotation and a shift.

const RAD = Math.PI / 180;

export const identity = () => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

export function multiply(a, b) {
  const m = new Array(12);
  for (let r = 0; r < 12; r += 4) {
    for (let c = 0; c < 4; c += 1) {
      m[r + c] = a[r] * b[c] + a[r + 1] * b[4 + c] + a[r + 2] * b[8 + c] + (c === 3 ? a[r + 3] : 0);
    }
  }
  return m;
}

/** Where a point of the frame stands. */
export const point = (m, [x, y, z]) => [
  m[0] * x + m[1] * y + m[2] * z + m[3],
  m[4] * x + m[5] * y + m[6] * z + m[7],
  m[8] * x + m[9] * y + m[10] * z + m[11],
];

const shift = ([x, y, z]) => [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z];

/** A turn about an axis by an angle (Rodrigues). */
function turn([x, y, z], angle) {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const v = 1 - c;
  return [
    c + x * x * v, x * y * v - z * s, x * z * v + y * s, 0,
    y * x * v + z * s, c + y * y * v, y * z * v - x * s, 0,
    z * x * v - y * s, z * y * v + x * s, c + z * z * v, 0,
  ];
}

const X = [1, 0, 0];
const Y = [0, 1, 0];
const Z = [0, 0, 1];

/** Fixed-axis roll, pitch, yaw, as robot files have it. */
const fixed = ([roll, pitch, yaw]) => multiply(turn(Z, yaw * RAD), multiply(turn(Y, pitch * RAD), turn(X, roll * RAD)));

/** Turns one after the other about the moved axes, as a deformation table has it. */
const moved = ([rx, ry, rz]) => multiply(turn(X, rx * RAD), multiply(turn(Y, ry * RAD), turn(Z, rz * RAD)));

/** The arm of a robot file, ready to be posed. */
export function arm(robot) {
  const frame = ({ origin_mm, rpy_deg }) => ({ place: shift(origin_mm), turned: fixed(rpy_deg) });
  const joints = robot.joint.map((joint) => ({
    frame: frame(joint), axis: joint.axis, slides: joint.type === 'prismatic', range: joint.range_deg ?? joint.range_mm,
  }));
  return { joints, flange: frame(robot.flange) };
}

/**
 * The frames of the joints (moved) and of the flange in the base, at joint angles in degrees (travels in mm); `offsets` are
 * rows of dx, dy, dz in mm and rx, ry, rz in deg for each joint and the flange, `turns` are added to the joints, both enlarged `times` times.
 */
export function frames(arm, q, { offsets = null, turns = null } = {}, times = 1) {
  const all = [];
  let at = identity();
  const moveTo = ({ place, turned }, row) => {
    at = multiply(at, place);
    if (row) {
      const d = row.map((value) => value * times);
      at = multiply(at, multiply(shift(d.slice(0, 3)), moved(d.slice(3))));
    }
    at = multiply(at, turned);
  };
  arm.joints.forEach((joint, i) => {
    moveTo(joint.frame, offsets?.[i]);
    const really = q[i] + (turns?.[i] ?? 0) * times;
    at = multiply(at, joint.slides ? shift(joint.axis.map((c) => c * really)) : turn(joint.axis, really * RAD));
    all.push(at);
  });
  moveTo(arm.flange, offsets?.[arm.joints.length]);
  all.push(at);
  return all;
}
