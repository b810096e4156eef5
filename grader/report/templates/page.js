"use strict";
// The pages read well without this script: every frame is shown, side by side. It adds the choice of a
// frame and the slider. A picture stands in the page once; the slider borrows it.
(() => {
  const root = document.documentElement;

  function pixels(image) {
    const canvas = document.createElement("canvas");
    canvas.width = image.naturalWidth;
    canvas.height = image.naturalHeight;
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    return (x, y) => [...context.getImageData(x, y, 1, 1).data.slice(0, 3)].map((v) => String(v).padStart(3)).join(" ");
  }

  // The slider of a scene, on the frame that `show` is given.
  function makeViewer(viewer) {
    const pane = viewer.querySelector(".pane");
    const stack = viewer.querySelector(".stack");
    const [under, over] = stack.querySelectorAll("img");
    const divider = stack.querySelector(".divider");
    const range = viewer.querySelector("input");
    const zoom = viewer.querySelector("select");
    const probe = viewer.querySelector("output");
    const { who, reference: referenceWord, columns } = viewer.dataset;
    let student, reference, readers, width = 1, scale = 1;

    // The range counts the picture's own pixels, so the divider always stands between two of them.
    const split = () => {
      over.style.clipPath = `inset(0 ${(width - range.value) * scale}px 0 0)`;
      divider.style.left = `${range.value * scale}px`;
      range.setAttribute("aria-valuetext", columns.replace("%1", range.value).replace("%2", width));
    };
    const fit = () => {
      const room = viewer.clientWidth;
      if (room === 0 || !student) return;
      scale = zoom.value === "fit" ? Math.min(1, room / width) : Number(zoom.value);
      for (const image of [under, over]) image.style.width = `${width * scale}px`;
      stack.classList.toggle("sharp", scale > 1);
      range.style.width = pane.style.width = `${Math.min(width * scale, room)}px`;
      split();
    };
    const show = (frame) => {
      [student, reference] = ["student", "reference"].map((role) => frame.querySelector(`img.${role}`));
      viewer.hidden = !student || !reference || student.getAttribute("width") !== reference.getAttribute("width")
        || student.getAttribute("height") !== reference.getAttribute("height");
      if (viewer.hidden) return;
      const share = range.value / range.max;
      width = Number(student.getAttribute("width"));
      range.max = width;
      range.value = Math.round(share * width);
      under.src = reference.src;
      over.src = student.src;
      readers = undefined;
      probe.value = "";
      fit();
    };

    const pixelAt = (event) => {
      const box = stack.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top].map((v) => v / scale);
    };
    const drag = (event) => { range.value = Math.round(pixelAt(event)[0]); split(); };
    stack.addEventListener("pointerdown", (event) => {
      drag(event);
      stack.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    stack.addEventListener("pointermove", (event) => {
      if (stack.hasPointerCapture(event.pointerId)) drag(event);
      readers ??= [pixels(student), pixels(reference)];
      const [x, y] = pixelAt(event).map(Math.floor);
      if (x < 0 || y < 0 || x >= width || y >= student.naturalHeight) return;
      probe.value = `(${x}, ${y})  ${who} ${readers[0](x, y)}  ${referenceWord} ${readers[1](x, y)}`;
    });
    stack.addEventListener("pointerleave", () => { probe.value = ""; });
    range.addEventListener("input", split);
    zoom.addEventListener("change", fit);
    addEventListener("resize", fit);
    return { show, fit };
  }

  function setUpScene(scene) {
    const frames = [...scene.querySelectorAll(".frame")];
    const choices = [...scene.querySelectorAll(".frames input")];
    const element = scene.querySelector(".viewer");
    const viewer = element && makeViewer(element);
    const show = () => {
      const chosen = Math.max(0, choices.findIndex((choice) => choice.checked));
      frames.forEach((frame, i) => { frame.hidden = i !== chosen; });
      if (viewer && frames[chosen]) viewer.show(frames[chosen]);
    };
    if (choices.length > 0) scene.querySelector(".frames").hidden = false;
    choices.forEach((choice) => choice.addEventListener("change", show));
    if (viewer) scene.querySelector("details").addEventListener("toggle", viewer.fit);
    show();
  }

  function openTarget() {
    const id = decodeURIComponent(location.hash.slice(1));
    const target = id && document.getElementById(id);
    if (!target) return;
    const details = target.querySelector(":scope > details");
    if (details) details.open = true;
    target.scrollIntoView();
  }

  document.querySelectorAll(".scene").forEach(setUpScene);
  addEventListener("hashchange", openTarget);
  addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((d) => { d.open = true; }));
  openTarget();
  root.dataset.ready = "true";
})();
