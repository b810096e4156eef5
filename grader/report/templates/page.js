"use strict";
// The pages read well without this script: every frame is shown, side by side. It adds the choice of a
// frame and the slider. A picture stands in the page once; the slider borrows it.
(() => {
  const root = document.documentElement;

  function chooseFrames(scene) {
    const frames = [...scene.querySelectorAll(".frame")];
    const choices = [...scene.querySelectorAll(".frames input")];
    const show = () => choices.forEach((choice, i) => { frames[i].hidden = !choice.checked; });
    choices.forEach((choice) => choice.addEventListener("change", () => { show(); fitAll(); }));
    if (choices.length > 0) {
      scene.querySelector(".frames").hidden = false;
      show();
    }
  }

  function pixels(image) {
    const canvas = document.createElement("canvas");
    canvas.width = image.naturalWidth;
    canvas.height = image.naturalHeight;
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    return (x, y) => [...context.getImageData(x, y, 1, 1).data.slice(0, 3)].map((v) => String(v).padStart(3)).join(" ");
  }

  const fits = [];
  const fitAll = () => fits.forEach((fit) => fit());

  function setUpViewer(frame) {
    const viewer = frame.querySelector(".viewer");
    if (!viewer) return;
    const [student, reference] = ["student", "reference"].map((who) => frame.querySelector(`img.${who}`));
    const pane = viewer.querySelector(".pane");
    const stack = viewer.querySelector(".stack");
    const under = stack.querySelector(".under");
    const over = stack.querySelector(".over");
    const divider = stack.querySelector(".divider");
    const range = viewer.querySelector("input");
    const zoom = viewer.querySelector("select");
    const probe = viewer.querySelector("output");
    const width = Number(range.max);
    let scale = 1;
    under.src = reference.src;
    over.src = student.src;

    // The range counts the picture's own pixels, so the divider always stands between two of them.
    const split = () => {
      over.style.clipPath = `inset(0 ${(width - range.value) * scale}px 0 0)`;
      divider.style.left = `${range.value * scale}px`;
      range.setAttribute("aria-valuetext", `${range.value} of ${width} columns from ${viewer.dataset.who}`);
    };
    const fit = () => {
      if (frame.hidden || viewer.parentElement.clientWidth === 0) return;
      const room = Math.min(viewer.parentElement.clientWidth, 760);
      scale = zoom.value === "fit" ? Math.min(1, room / width) : Number(zoom.value);
      for (const image of [under, over]) image.style.width = `${width * scale}px`;
      stack.classList.toggle("sharp", scale > 1);
      const shown = Math.min(width * scale, room);
      pane.style.width = `${shown}px`;
      range.style.width = `${shown}px`;
      split();
    };
    fits.push(fit);
    range.addEventListener("input", split);
    zoom.addEventListener("change", fit);

    const column = (event) => Math.round((event.clientX - stack.getBoundingClientRect().left) / scale);
    const drag = (event) => { range.value = column(event); split(); };
    stack.addEventListener("pointerdown", (event) => {
      drag(event);
      stack.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    let readers;
    stack.addEventListener("pointermove", (event) => {
      if (stack.hasPointerCapture(event.pointerId)) drag(event);
      readers ??= [pixels(student), pixels(reference)];
      const box = stack.getBoundingClientRect();
      const x = Math.floor((event.clientX - box.left) / scale);
      const y = Math.floor((event.clientY - box.top) / scale);
      if (x < 0 || y < 0 || x >= width || y >= student.naturalHeight) return;
      probe.value = `(${x},${y})  ${viewer.dataset.who} ${readers[0](x, y)}   reference ${readers[1](x, y)}`;
    });
    viewer.hidden = false;
  }

  function openTarget() {
    const id = decodeURIComponent(location.hash.slice(1));
    const target = id && document.getElementById(id);
    if (!target) return;
    target.querySelectorAll(":scope > details").forEach((details) => { details.open = true; });
    target.scrollIntoView();
  }

  for (const scene of document.querySelectorAll(".scene")) {
    scene.querySelectorAll(".frame").forEach(setUpViewer);
    chooseFrames(scene);
    scene.querySelector("details").addEventListener("toggle", fitAll);
  }
  fitAll();
  addEventListener("resize", fitAll);
  addEventListener("hashchange", openTarget);
  addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((d) => { d.open = true; }));
  openTarget();
  root.dataset.ready = "true";
})();
