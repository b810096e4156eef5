"use strict";
// The page reads well without this script: every pass is shown, one under another. It adds the choice of a
// pass and the viewer with the exact values, which stand in the page deflated.
(() => {
  const root = document.documentElement;
  const kTypes = {
    u8x4: [4, 4], u8x1: [1, 1], f16x4: [8, 4], f32x4: [16, 4], f32x1: [4, 1], i32x4: [16, 4], u32x4: [16, 4],
  }; // bytes and channels of a pixel

  function halves(bits) {
    const table = new Float32Array(65536);
    for (let i = 0; i < 65536; ++i) {
      const exponent = (i >> 10) & 31, fraction = i & 1023;
      const size = exponent === 0 ? fraction * 2 ** -24
        : exponent === 31 ? (fraction ? NaN : Infinity) : (1 + fraction / 1024) * 2 ** (exponent - 15);
      table[i] = i & 0x8000 ? -size : size;
    }
    halves = (more) => Float32Array.from(more, (b) => table[b]);
    return halves(bits);
  }

  // Undoes packedValues of inspect_pixels.cpp.
  async function unpack(id, type, count) {
    const packed = Uint8Array.from(atob(document.getElementById(id).textContent), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    const runs = new Uint8Array(await new Response(stream).arrayBuffer());
    const size = kTypes[type][0], bytes = new Uint8Array(count * size);
    for (let k = 0; k < size; ++k)
      for (let i = 0, value = 0; i < count; ++i) {
        value = (value + runs[k * count + i]) & 255;
        bytes[i * size + k] = value;
      }
    if (type.startsWith("u8")) return bytes;
    if (type === "f16x4") return halves(new Uint16Array(bytes.buffer));
    const Kind = { f: Float32Array, i: Int32Array, u: Uint32Array }[type[0]];
    return new Kind(bytes.buffer);
  }

  const unpacked = new Map(); // the last few: a picture of a million pixels takes 16 MB
  function valuesOf(picture) {
    const id = picture.values;
    if (!unpacked.has(id)) {
      unpacked.set(id, unpack(id, picture.type, picture.width * picture.height));
      if (unpacked.size > 4) unpacked.delete(unpacked.keys().next().value);
    }
    return unpacked.get(id);
  }

  // With as few digits as tell a float from its neighbours.
  function shortest(value) {
    if (!Number.isFinite(value)) return Number.isNaN(value) ? "NaN" : value > 0 ? "+Inf" : "-Inf";
    for (let digits = 1; digits < 10; ++digits) {
      const text = Number(value.toPrecision(digits));
      if (Math.fround(text) === Math.fround(value)) return String(text);
    }
    return String(value);
  }

  const encodeSrgb = (v) => v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055;

  function makeViewer(element) {
    const words = element.dataset; // in the student's language
    const find = (selector) => element.querySelector(selector);
    const pane = find(".pane"), canvas = find("canvas"), context = canvas.getContext("2d", { willReadFrequently: true });
    const mark = find(".mark"), probe = find(".probe");
    const channelBox = find(".channels"), exposure = find(".exposure input"), encode = find(".encode input");
    const [black, white] = element.querySelectorAll(".between input");
    let picture, values, scale = 1, fitted = true, at;

    const isDepth = () => picture.type === "f32x1";
    const isWhole = () => /^[iu]32|u8x1/.test(picture.type);
    const distance = (depth) => picture.linear ? picture.linear[0] / (2 * depth - 1 - picture.linear[1]) : depth;

    const depthAt = (distance) => picture.linear ? (picture.linear[0] / distance + 1 + picture.linear[1]) / 2 : distance;
    // As evenDepth of grader/trace/picture.hpp.
    const even = (depth) => -Math.log2(1 - Math.min(Math.max(depth, 0), 1) + 2 ** -12) / 12;

    // The colour of a value as 0 to 255; what isn't a number is told apart in `paint`.
    function mapping() {
      const clamp = (v) => v * 255; // the array of pixels rounds and clamps
      if (isDepth()) {
        const low = even(depthAt(Number(black.value))), range = even(depthAt(Number(white.value))) - low || 1;
        return (depth) => depth >= 1 ? 255 : clamp((even(depth) - low) / range);
      }
      if (isWhole()) return (v) => clamp(v / (picture.high || 1));
      const factor = 2 ** Number(exposure.value) / (picture.type === "u8x4" ? 255 : 1);
      return encode.checked ? (v) => clamp(encodeSrgb(v * factor)) : (v) => clamp(v * factor);
    }

    function paint() {
      const channel = element.querySelector("[name=channel]:checked").value;
      const channels = kTypes[picture.type][1];
      find(".exposure output").value = `${exposure.value > 0 ? "+" : ""}${Number(Number(exposure.value).toFixed(2))} EV`;
      if (!values || (isWhole() && (channel === "rgb" || channels === 1))) {
        if (picture.image) context.drawImage(picture.image, 0, 0, canvas.width, canvas.height);
        return;
      }
      const data = context.createImageData(picture.width, picture.height), out = data.data, map = mapping();
      const from = channels === 1 ? [0, 0, 0] : channel === "rgb" ? [0, 1, 2] : Array(3).fill(Number(channel));
      for (let i = 0, o = 0; o < out.length; i += channels, o += 4) {
        const r = values[i + from[0]], g = values[i + from[1]], b = values[i + from[2]], sum = r + g + b;
        out[o + 3] = 255;
        if (sum - sum === 0) {
          out[o] = map(r); out[o + 1] = map(g); out[o + 2] = map(b);
        } else { // Magenta: NaN. Cyan: infinite, and nowhere NaN.
          const nan = r !== r || g !== g || b !== b;
          out[o] = nan ? 255 : 0; out[o + 1] = nan ? 0 : 255; out[o + 2] = 255;
        }
      }
      context.putImageData(data, 0, 0);
    }

    function read() {
      mark.hidden = !at || scale < 4;
      if (!at) { probe.value = values ? words.point : picture.values ? "" : words.noValues; return; }
      const [x, y] = at;
      mark.style.cssText = `left:${x * scale}px;top:${y * scale}px;width:${scale}px;height:${scale}px`;
      const place = `${words.place.replace("%1", x).replace("%2", y)} (gl_FragCoord ${x + 0.5}, ${picture.height - y - 0.5})`;
      if (!values) { probe.value = place; return; }
      const channels = kTypes[picture.type][1], i = (y * picture.width + x) * channels;
      const pixel = [...values.slice(i, i + channels)];
      const one = (v) => picture.type === "u8x4" ? `${v} (${(v / 255).toFixed(3)})` : shortest(v);
      let text = channels === 1 ? `${isDepth() ? words.depth : words.stencil} ${one(pixel[0])}`
        : pixel.map((v, c) => `${"RGBA"[c]} ${one(v)}`).join("   ");
      if (picture.linear && pixel[0] < 1) text += `   ${words.distance} ${distance(pixel[0]).toPrecision(5)}`;
      probe.value = `${place}\n${text}`;
    }

    function zoom(to, keep) {
      const before = scale, box = pane.getBoundingClientRect();
      const room = pane.clientWidth;
      fitted = to === "fit";
      scale = fitted ? Math.min(room / picture.width, innerHeight * 0.66 / picture.height, 16) : Math.min(64, Math.max(1 / 16, to));
      if (fitted && scale > 1) scale = Math.floor(scale);
      canvas.style.width = `${picture.width * scale}px`;
      canvas.style.height = `${picture.height * scale}px`;
      pane.classList.toggle("sharp", scale >= 1);
      find(".scale").value = scale >= 1 ? `${Math.round(scale * 100) / 100}x` : `${Math.round(scale * 100)}%`;
      if (keep) {
        const [x, y] = [keep.clientX - box.left, keep.clientY - box.top];
        pane.scrollLeft = (pane.scrollLeft + x) * scale / before - x;
        pane.scrollTop = (pane.scrollTop + y) * scale / before - y;
      }
      read();
    }

    function reset() {
      element.querySelector("[name=channel]").checked = true;
      const range = picture.type === "u8x4" || picture.high <= 1 ? 0 : -Math.log2(picture.high);
      exposure.step = "any"; // the picture's own may stand between two stops
      exposure.value = range;
      exposure.step = Number.isInteger(range) ? "0.25" : "any";
      encode.checked = false;
      black.value = Number(picture.low.toPrecision(6));
      white.value = Number(picture.high.toPrecision(6));
      paint();
    }

    async function show(figure) {
      const data = figure.dataset;
      picture = {
        type: data.type, width: Number(data.width), height: Number(data.height), values: data.values,
        low: Number(data.low), high: Number(data.high), linear: data.linear && data.linear.split(" ").map(Number),
        image: figure.querySelector("img"),
      };
      const mine = picture;
      values = at = undefined;
      canvas.width = picture.width;
      canvas.height = picture.height;
      channelBox.hidden = isDepth() || picture.type === "u8x1";
      find(".exposure").hidden = find(".encode").hidden = isDepth() || isWhole();
      find(".between").hidden = !isDepth();
      find(".unit").textContent = picture.linear ? words.fromEye : "";
      zoom("fit");
      if (picture.image && !picture.image.complete) await picture.image.decode().catch(() => {});
      if (mine !== picture) return;
      reset();
      if (!picture.values) return;
      const got = await valuesOf(picture);
      if (mine !== picture) return; // another one was chosen meanwhile
      values = got;
      paint();
      read();
      element.dataset.shown = picture.values;
    }

    const point = (event) => {
      const box = canvas.getBoundingClientRect();
      const x = Math.floor((event.clientX - box.left) / scale), y = Math.floor((event.clientY - box.top) / scale);
      if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
      at = [x, y];
      read();
    };
    pane.addEventListener("pointermove", point);
    pane.addEventListener("pointerdown", point);
    pane.addEventListener("wheel", (event) => {
      if (document.activeElement !== pane && !event.ctrlKey) return; // the page scrolls
      event.preventDefault();
      zoom(scale * (event.deltaY < 0 ? 1.25 : 0.8), event);
    }, { passive: false });
    pane.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (event.key === "+" || event.key === "-") zoom(scale * (event.key === "+" ? 1.25 : 0.8));
      if (!step) return;
      event.preventDefault();
      event.stopPropagation();
      const limit = [picture.width, picture.height];
      at = (at || limit.map((n) => n >> 1)).map((v, i) => Math.min(limit[i] - 1, Math.max(0, v + step[i])));
      read();
      mark.scrollIntoView({ block: "nearest", inline: "nearest" });
    });
    for (const input of element.querySelectorAll("input")) input.addEventListener("input", paint);
    find(".reset").addEventListener("click", reset);
    for (const button of element.querySelectorAll("[data-zoom]"))
      button.addEventListener("click", () => {
        const to = button.dataset.zoom;
        zoom({ in: scale * 2, out: scale / 2, fit: "fit", 1: 1 }[to]);
      });
    addEventListener("resize", () => { if (picture && fitted) zoom("fit"); });
    return show;
  }

  const element = document.querySelector(".viewer");
  const passes = [...document.querySelectorAll(".pass")];
  const show = element && makeViewer(element);
  let current;

  function showPicture(figure) {
    for (const other of figure.parentElement.children) other.classList.toggle("current", other === figure);
    show(figure);
  }

  // Not scrollIntoView, which may move the page, too.
  function reveal(card) {
    const film = card.closest(".film"), box = card.getBoundingClientRect(), room = film.getBoundingClientRect();
    if (box.left < room.left) film.scrollLeft -= room.left - box.left + 40;
    if (box.right > room.right) film.scrollLeft += box.right - room.right + 40;
  }

  function select(pass, { scroll = false } = {}) {
    if (!pass || pass === current) return;
    current = pass;
    const number = pass.dataset.number;
    for (const other of passes) other.hidden = other !== pass;
    const near = new Set();
    for (const arc of document.querySelectorAll(".arc")) {
      const { from, to } = arc.dataset, related = from === number || to === number;
      arc.classList.toggle("related", related);
      if (related) near.add(from).add(to);
    }
    for (const link of document.querySelectorAll(".pass-card, .timebar a")) {
      const mine = link.dataset.to === number;
      link.classList.toggle("current", mine);
      link.classList.toggle("related", !mine && near.has(link.dataset.to));
      if (link.matches(".pass-card")) {
        if (mine) link.setAttribute("aria-current", "true"); else link.removeAttribute("aria-current");
        if (mine) reveal(link);
      }
    }
    const figure = pass.querySelector(".pictures figure");
    element.hidden = !figure;
    if (figure) {
      pass.querySelector(".place").append(element);
      showPicture(figure);
    }
    const isFirst = pass === passes[0] && location.hash === "";
    if (!isFirst && location.hash !== `#pass-${number}`) history.replaceState(null, "", `#pass-${number}`);
    if (scroll) pass.scrollIntoView({ block: "nearest" });
  }

  const byNumber = (number) => document.getElementById(`pass-${number}`);
  function go(step) {
    const next = passes[passes.indexOf(current) + step];
    const inFilm = document.activeElement && document.activeElement.matches(".pass-card");
    select(next);
    if (next && inFilm) document.getElementById(`card-${next.dataset.number}`).focus();
  }

  if (passes.length > 0) {
    for (const pictures of document.querySelectorAll(".pictures")) {
      pictures.classList.toggle("single", pictures.children.length === 1);
      for (const figure of pictures.children) {
        const button = document.createElement("button");
        button.type = "button";
        button.append(...figure.childNodes);
        figure.append(button);
        button.addEventListener("click", () => showPicture(figure));
      }
    }
    document.addEventListener("click", (event) => {
      const link = event.target.closest("a[data-to]");
      if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      select(byNumber(link.dataset.to), { scroll: !link.matches(".pass-card") });
    });
    document.addEventListener("mouseover", (event) => {
      const link = event.target.closest(".pass a[data-to]");
      for (const card of document.querySelectorAll(".pass-card.pointed")) card.classList.remove("pointed");
      if (link) document.getElementById(`card-${link.dataset.to}`)?.classList.add("pointed");
    });
    document.addEventListener("keydown", (event) => {
      const typing = event.target.matches?.("input, select, textarea, .pane");
      if (typing || event.ctrlKey || event.altKey || event.metaKey || event.shiftKey) return;
      const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (!step) return;
      event.preventDefault();
      go(step);
    });
    addEventListener("hashchange", () => select(document.querySelector(location.hash || "#pass-1")));
    addEventListener("beforeprint", () => document.querySelectorAll("details").forEach((d) => { d.open = true; }));
    document.querySelector(".keys").hidden = false;
    root.dataset.ready = "true";
    const asked = /^#pass-\d+$/.test(location.hash) && document.querySelector(location.hash);
    select(asked || passes[0]);
  } else {
    root.dataset.ready = "true";
  }
})();
