"use strict";
(() => {
  const study = JSON.parse(document.getElementById("data").textContent);
  const element = (id) => document.getElementById(id);
  const clips = new Map(study.clips.map((clip) => [clip.id, clip]));
  const SCALE = [[1, "1, very poor"], [2, "2, poor"], [3, "3, fair"], [4, "4, good"], [5, "5, excellent"]];
  const EITHER = [["first", "First film"], ["second", "Second film"], ["same", "No difference"]];

  // A participant is a random number; order and sides follow from it and the study's seed.
  const participant = crypto.getRandomValues(new Uint32Array(1))[0];

  function generator(seed) {  // mulberry32
    let state = seed >>> 0;
    return () => {
      state = (state + 0x6d2b79f5) >>> 0;
      let t = state;
      t = Math.imul(t ^ (t >>> 15), t | 1);
      t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
      return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
    };
  }

  function shuffled(items, random) {
    const out = items.slice();
    for (let k = out.length - 1; k > 0; k -= 1) {
      const j = Math.floor(random() * (k + 1));
      [out[k], out[j]] = [out[j], out[k]];
    }
    return out;
  }

  const random = generator((study.seed ^ participant) >>> 0);
  const steps = [
    ...shuffled(study.clips.map((clip) => ({ clip: clip.id })), random),
    ...shuffled(study.pairs, random).map((pair) => ({ pair: shuffled(pair, random) })),
  ];
  const answers = {
    format: "esg-study-answers", version: 1, study: study.study, participant,
    consent: true, ratings: [], pairs: [],
  };
  let at = 0;
  let shown = 0;

  function show(id) {
    for (const part of ["consent", "rate", "pair", "done"]) element(part).hidden = part !== id;
    element(id).querySelector("h1").focus();
    window.scrollTo(0, 0);
  }

  function choices(fieldset, name, options) {
    for (const old of fieldset.querySelectorAll("label")) old.remove();
    for (const [value, words] of options) {
      const label = document.createElement("label");
      const input = document.createElement("input");
      input.type = "radio";
      input.name = name;
      input.value = value;
      input.required = true;
      label.append(input, ` ${words}`);
      fieldset.append(label);
    }
  }

  function chosen(form, name) {
    return new FormData(form).get(name);
  }

  function film(id, clip) {
    const video = element(id);
    video.src = `data:video/mp4;base64,${clip.film}`;
    video.load();
  }

  function next() {
    if (at >= steps.length) {
      finish();
      return;
    }
    const step = steps[at];
    element("progress").textContent = `${at + 1} of ${steps.length}`;
    shown = performance.now();
    if (step.clip !== undefined) {
      const clip = clips.get(step.clip);
      element("rate-title").textContent = `Film ${at + 1} of ${steps.length}`;
      element("rate-prompt").textContent = clip.prompt;
      film("rate-film", clip);
      choices(element("quality"), "quality", SCALE);
      choices(element("alignment"), "alignment", SCALE);
      show("rate");
      return;
    }
    const [first, second] = step.pair.map((id) => clips.get(id));
    element("pair-title").textContent = `Two films, ${at + 1} of ${steps.length}`;
    element("pair-prompt").textContent = first.prompt;
    film("pair-first", first);
    film("pair-second", second);
    choices(element("better-quality"), "quality", EITHER);
    choices(element("better-alignment"), "alignment", EITHER);
    show("pair");
  }

  function seconds() {
    return Math.round((performance.now() - shown) / 100) / 10;
  }

  function finish() {
    element("progress").textContent = "All done.";
    const text = JSON.stringify(answers, null, 1);
    const link = element("save");
    link.href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
    link.download = `answers-${study.study}-${participant}.json`;
    show("done");
    window.removeEventListener("beforeunload", warn);
  }

  function warn(event) {
    event.preventDefault();
  }

  element("consent-text").textContent = study.consent;
  element("agree").addEventListener("change", (event) => {
    element("begin").disabled = !event.target.checked;
  });
  element("begin").addEventListener("click", () => {
    window.addEventListener("beforeunload", warn);
    next();
  });
  element("rate").addEventListener("submit", (event) => {
    event.preventDefault();
    const form = event.target;
    answers.ratings.push({
      clip: steps[at].clip, quality: Number(chosen(form, "quality")),
      alignment: Number(chosen(form, "alignment")), seconds: seconds(),
    });
    at += 1;
    next();
  });
  element("pair").addEventListener("submit", (event) => {
    event.preventDefault();
    const form = event.target;
    const [first, second] = steps[at].pair;
    const pick = (name) => ({ first, second, same: null })[chosen(form, name)];
    answers.pairs.push({
      first, second, quality: pick("quality"), alignment: pick("alignment"), seconds: seconds(),
    });
    at += 1;
    next();
  });
})();
