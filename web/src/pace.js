// How much of a picture there is time for: all of it where a GPU draws. Where a processor stands for
// one, a rough picture while something moves, and a fine one when nothing has for a while.

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
const LATE_MS = 100;
const LATE_FRAMES = 6; // in a row; building and compiling delay some on any machine
const REST_MS = 600;

// A WebGL context, and whether a processor draws for it: smooth edges cost it half its time.
export function contextOf(canvas) {
  const slow = SOFTWARE.test(painter());
  const context = canvas.getContext("webgl2", { preserveDrawingBuffer: true, antialias: !slow });
  if (!context) throw new Error("no WebGL");
  return { context, slow };
}

// The name of what draws; empty where the browser keeps it to itself.
function painter() {
  const probe = document.createElement("canvas").getContext("webgl2");
  const told = probe?.getExtension("WEBGL_debug_renderer_info");
  const name = told ? probe.getParameter(told.UNMASKED_RENDERER_WEBGL) : "";
  probe?.getExtension("WEBGL_lose_context")?.loseContext();
  return name;
}

export function createPace(slow) {
  let drawn = -1;
  let late = 0;
  let changed = 0;
  let rough = false;
  return {
    // What to draw now: "fine", "rough" or nothing.
    next(now, dirty) {
      if (drawn >= 0) {
        late = now - drawn > LATE_MS ? late + 1 : 0;
        changed = now; // it took until now
      }
      drawn = -1;
      slow ||= late >= LATE_FRAMES;
      if (dirty) {
        drawn = now;
        rough = slow;
        return slow ? "rough" : "fine";
      }
      if (!rough || now - changed < REST_MS) return null;
      rough = false;
      return "fine";
    },
  };
}
