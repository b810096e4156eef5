"use strict";
// The page reads well without this script: a plain table in the order of the names. It adds sorting,
// filters, and the histogram's bars as a filter.
(() => {
  const root = document.documentElement;
  const section = document.getElementById("students");
  const table = section.querySelector("table");

  // What a cell is sorted by; null where it has nothing, which stands last in both directions.
  const keys = {
    text: (cell) => cell.querySelector(".key")?.textContent || null,
    number: (cell) => cell.dataset.value === undefined ? null : Number(cell.dataset.value),
    time: (cell) => { const time = Date.parse(cell.dataset.value); return Number.isNaN(time) ? null : time; },
  };
  const collator = new Intl.Collator(undefined, { numeric: true });
  const compare = (a, b) => typeof a === "string" ? collator.compare(a, b) : a - b;

  // Equal rows keep the order that they have, so that sorting by two columns in turn works.
  function sortBy(heading) {
    const body = table.tBodies[0], index = heading.cellIndex, keyOf = keys[heading.dataset.sort];
    const ascending = heading.getAttribute("aria-sort") !== "ascending";
    for (const other of heading.parentElement.cells) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", ascending ? "ascending" : "descending");
    const entries = [...body.rows].map((row) => ({ row, key: keyOf(row.cells[index]) }));
    entries.sort((a, b) => a.key === null || b.key === null ? (a.key === null) - (b.key === null)
      : (ascending ? 1 : -1) * compare(a.key, b.key));
    body.append(...entries.map((entry) => entry.row));
  }

  function setUpSorting() {
    for (const heading of table.tHead.rows[0].cells) {
      if (!heading.dataset.sort) continue;
      const button = document.createElement("button");
      button.type = "button";
      button.append(...heading.childNodes);
      button.addEventListener("click", () => sortBy(heading));
      heading.append(button);
    }
  }

  function setUpFilters() {
    const controls = section.querySelector(".controls"), status = section.querySelector(".shown");
    const { find, outcome } = controls.elements;
    const clear = controls.querySelector("button"), chosen = controls.querySelector(".chosen-bin");
    const bins = [...document.querySelectorAll(".bins a")];
    const plain = (text) => text.normalize("NFKC").toLowerCase();
    const rows = [...table.tBodies[0].rows].map((row) => ({
      row,
      text: plain([...row.querySelectorAll(".key, .student, .what, .adjustments")].map((e) => e.textContent).join("\n")),
    }));
    let bin; // the link of the chosen bar

    const apply = () => {
      const wanted = plain(find.value.trim());
      let shown = 0;
      for (const { row, text } of rows) {
        row.hidden = !text.includes(wanted) || (outcome.value !== "" && row.dataset.outcome !== outcome.value)
          || (bin !== undefined && row.dataset.bin !== bin.dataset.bin);
        if (!row.hidden) ++shown;
      }
      for (const link of bins) link.setAttribute("aria-current", link === bin);
      chosen.hidden = !bin;
      chosen.textContent = bin ? `final score ${bin.dataset.range}` : "";
      clear.hidden = !bin && wanted === "" && outcome.value === "";
      status.textContent = clear.hidden ? `${rows.length} student${rows.length === 1 ? "" : "s"}`
        : `${shown} of ${rows.length} student${rows.length === 1 ? "" : "s"} shown`;
    };
    find.addEventListener("input", apply);
    outcome.addEventListener("change", apply);
    controls.addEventListener("submit", (event) => event.preventDefault());
    clear.addEventListener("click", () => {
      controls.reset();
      bin = undefined;
      apply();
      find.focus(); // the button is gone
    });
    // A row that is hidden can't be gone to.
    for (const link of document.querySelectorAll(".needs a"))
      link.addEventListener("click", () => {
        controls.reset();
        bin = undefined;
        apply();
      });
    for (const link of bins)
      link.addEventListener("click", (event) => {
        if (bin === link) event.preventDefault(); // given up: no need to go to the table
        bin = bin === link ? undefined : link;
        apply();
      });
    controls.hidden = false;
    apply();
  }

  if (table) {
    setUpSorting();
    setUpFilters();
  }
  root.dataset.ready = "true";
})();
