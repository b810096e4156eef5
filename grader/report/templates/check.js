// A page that is written anew at every save shows itself again; it keeps its place, and the hints of a fault that were
// opened stay open for as long as it is the same fault.
for (const fold of document.querySelectorAll("details[data-fold]")) {
  const name = `ggrade ${document.title} ${fold.dataset.fold}`;
  try {
    fold.open = sessionStorage.getItem(name) === "open";
    fold.addEventListener("toggle", () => {
      if (fold.open) sessionStorage.setItem(name, "open");
      else sessionStorage.removeItem(name);
    });
  } catch { // a browser that keeps nothing for files
  }
}
if (document.body.dataset.watched) setTimeout(() => location.reload(), 1000);
