"use strict";
// Sorts tables, copies them as CSV, switches the scheme. Without it the page still reads as it is.
const report = (() => {
  const units = { kB: 1e3, MB: 1e6, GB: 1e9 };

  // "(1.23 ± 0.04)e-5", "+32 % ± 0.3 %", "877 kB", "2000 to 20000": the first number, as large as it is. NaN without one.
  function value(text) {
    const found = text.trim().match(/^(\()?([+-]?\d+(?:\.\d+)?(?:e[+-]?\d+)?)(?:[^)]*\)e([+-]?\d+))?\s*(kB|MB|GB)?/);
    if (!found) return NaN;
    const power = found[1] && found[3] ? Number(found[3]) : 0;
    return Number(found[2]) * 10 ** power * (units[found[4]] ?? 1);
  }

  // Numbers first, by size; then texts; empty cells last, whichever way it is sorted.
  function sort(table, column, direction) {
    const rows = [...table.tBodies[0].rows];
    rows.forEach((row, i) => (row.dataset.place ??= i));
    const place = (row) => Number(row.dataset.place);
    const compare = (a, b) => {
      if (direction === "none") return place(a) - place(b);
      const [s, t] = [a, b].map((row) => row.cells[column].textContent);
      const [x, y] = [value(s), value(t)];
      const rank = (text, number) => (text === "" ? 2 : Number.isNaN(number) ? 1 : 0);
      if (rank(s, x) !== rank(t, y)) return rank(s, x) - rank(t, y);
      const order = rank(s, x) === 0 ? x - y : s.localeCompare(t, "en", { numeric: true });
      return (direction === "descending" ? -order : order) || place(a) - place(b);
    };
    table.tBodies[0].append(...rows.sort(compare));
    for (const th of table.tHead.rows[0].cells) th.setAttribute("aria-sort", "none");
    table.tHead.rows[0].cells[column].setAttribute("aria-sort", direction);
  }

  // RFC 4180, as the table stands.
  function csv(table) {
    const field = (text) => (/[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
    return [...table.rows].map((row) => [...row.cells].map((cell) => field(cell.textContent)).join(",") + "\n").join("");
  }

  // Pages opened from a file may lack the clipboard.
  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      const area = document.body.appendChild(document.createElement("textarea"));
      area.value = text;
      area.select();
      document.execCommand("copy");
      area.remove();
    }
  }

  function button(text, action) {
    const made = document.createElement("button");
    made.type = "button";
    made.textContent = text;
    made.addEventListener("click", () => action(made));
    return made;
  }

  function equip(table) {
    [...table.tHead.rows[0].cells].forEach((th, column) => {
      const next = { none: "ascending", ascending: "descending", descending: "none" };
      const turn = () => sort(table, column, next[th.getAttribute("aria-sort") ?? "none"]);
      th.tabIndex = 0;
      th.title = "Sort";
      th.addEventListener("click", turn);
      th.addEventListener("keydown", (event) => event.key === "Enter" && turn());
    });
    const tools = document.createElement("div");
    tools.className = "tools";
    tools.append(button("Copy as CSV", async (self) => {
      await copy(csv(table));
      self.textContent = "Copied";
      setTimeout(() => (self.textContent = "Copy as CSV"), 1500);
    }));
    table.closest(".table").append(tools);
  }

  // What an outcome begins with has its colour, in tables and in sentences.
  function colour() {
    for (const place of document.querySelectorAll("main td:not(.n), main li em")) {
      if (/^(agrees|holds)\b/.test(place.textContent)) place.classList.add("good");
      if (/^(differs|failed|does not hold)\b/.test(place.textContent)) place.classList.add("bad");
    }
  }

  function scheme() {
    const root = document.documentElement;
    const dark = () => getComputedStyle(root).colorScheme === "dark";
    const name = () => (dark() ? "Light" : "Dark");
    const toggle = button(name(), (self) => {
      root.dataset.scheme = dark() ? "light" : "dark";
      self.textContent = name();
    });
    toggle.title = "Switch between light and dark";
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => (toggle.textContent = name()));
    return toggle;
  }

  // A link to what is folded unfolds it.
  function unfold() {
    const target = document.getElementById(location.hash.slice(1));
    if (target?.tagName === "DETAILS") target.open = true;
  }

  const tables = [...document.querySelectorAll("main table")];
  tables.forEach(equip);
  colour();
  document.querySelector("header").append(scheme());
  addEventListener("hashchange", unfold);
  unfold();
  document.documentElement.dataset.ready = tables.length;
  return { value, sort, csv };
})();
