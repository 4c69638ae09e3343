// What is to be drawn at a moment: the two frames around it, and what lies between them. Arrays are filled anew only
// when another frame, or another meaning of the colours, is wanted.

function makePicture(motion) {
  const {most, facts} = motion;
  const [before, after] = [0, 1].map(() => new Float32Array(3 * most));
  const [toneBefore, toneAfter] = [0, 1].map(() => new Float32Array(most));
  const strokes = facts.outlines.flatMap(line => line.slice(1).flatMap((p, k) => [line[k], p].flatMap(motion.scaled)));
  const picture = {
    before, after, toneBefore, toneAfter, radius: motion.radii, between: 0, swell: 1, jump: 0.5, count: 0,
    walls: new Float32Array(strokes), contacts: new Float32Array(0), contactLength: 0, fresh: true,
  };
  const noWalls = new Float32Array(0), allWalls = picture.walls;
  let shownFrame = -1, shownColouring = null;

  const centre = (out, i) => {
    for (let a = 0; a < 3; ++a) out[a] = before[3 * i + a] + picture.between * (after[3 * i + a] - before[3 * i + a]);
    return out;
  };
  const fillContacts = frame => {
    const pairs = motion.pairs(frame), touching = motion.touching(frame), towards = motion.towards(frame);
    const length = 3 * pairs.length + 6 * touching.length;
    if (picture.contacts.length < length) picture.contacts = new Float32Array(2 * length);
    const at = [0, 0, 0];
    let k = 0;
    for (const i of pairs) picture.contacts.set(centre(at, i), k), k += 3;
    touching.forEach((i, n) => {
      picture.contacts.set(centre(at, i), k);
      for (let a = 0; a < 3; ++a) at[a] += motion.radii[i] * towards[3 * n + a] / 127;
      picture.contacts.set(at, k + 3);
      k += 6;
    });
    picture.contactLength = length;
  };

  // A sphere that is there in one of the two frames only does not move between them.
  const stay = (now, then) => {
    const [from, to] = now < then ? [after, before] : [before, after], few = Math.min(now, then);
    to.set(from.subarray(3 * few, 3 * Math.max(now, then)), 3 * few);
    const [tone, other] = now < then ? [toneAfter, toneBefore] : [toneBefore, toneAfter];
    other.set(tone.subarray(few, Math.max(now, then)), few);
  };

  /// `moment` counts frames, with a fraction: places in between are on the straight line.
  picture.set = (moment, colouring, {contacts, walls}) => {
    const frame = Math.min(Math.floor(moment), motion.frames - 1), next = Math.min(frame + 1, motion.frames - 1);
    picture.fresh = frame !== shownFrame || colouring !== shownColouring;
    picture.between = moment - frame;
    if (picture.fresh) {
      motion.places(frame, before), colouring.fill(frame, toneBefore);
      motion.places(next, after), colouring.fill(next, toneAfter);
      stay(motion.count(frame), motion.count(next));
      shownFrame = frame, shownColouring = colouring;
    }
    picture.count = motion.count(picture.between < 0.5 ? frame : next);
    picture.table = colouring.table, picture.byName = Boolean(colouring.names);
    picture.swell = contacts ? 0.35 : 1;
    picture.walls = walls ? allWalls : noWalls;
    picture.contactLength = 0;
    if (contacts) fillContacts(picture.between < 0.5 ? frame : next);
  };
  return picture;
}
