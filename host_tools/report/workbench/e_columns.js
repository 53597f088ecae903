// The dialog that maps columns of a file; the engine's readers decide what is understood or refused.
"use strict";

// `look` returns what the engine understands of the file `name` with a value of --columns; `given` is the
// value so far. Resolves to the new value, or null if the user cancels.
const ask_for_columns = async (name, look, given) => {
  const dialog = byId("columns");
  const first = await look(given);
  const choices = new Map(); // quantity -> its selects { column, unit }

  const map = () =>
    first.keys
      .flatMap(({ key }) => {
        const { column, unit } = choices.get(key);
        if (column.value === "") return [];
        return [`${key}=${first.columns[column.value].choice}${unit.value ? `[${unit.value}]` : ""}`];
      })
      .join(",");

  // Shows what the engine says of the current choice; answers to earlier choices are dropped.
  let asked = 0;
  const judge = async () => {
    const turn = ++asked;
    show_judgement(turn, await look(map()));
  };
  const show_judgement = (turn, { refusal, remarks }) => {
    if (turn !== asked) return;
    byId("columns_said").textContent = [without_options(refusal), ...remarks].filter(Boolean).join(" ");
    byId("columns_said").classList.toggle("refused", refusal !== "");
    byId("columns_take").disabled = refusal !== "";
  };

  // A column whose name has a unit needs no other, but may be in another.
  const show_unit = ({ column, unit }) => {
    const own = column.value === "" ? "" : first.columns[column.value].unit;
    unit.disabled = column.value === "";
    unit.options[0].textContent = own || "no unit";
    [...unit.options].slice(1).forEach((option) => (option.hidden = option.value === own));
    if (unit.selectedOptions[0].hidden || unit.disabled) unit.value = "";
  };

  const row = ({ key, required, units }) => {
    // Preselects a column only if no other could be meant.
    const could_be = first.columns.flatMap((one, i) => (one.key === key ? [i] : []));
    const meant = could_be.length === 1 ? could_be[0] : -1;
    const column = make(
      "select",
      { ariaLabel: `column of ${key}` },
      make("option", { value: "", textContent: required ? "choose" : "none" }),
      ...first.columns.map((one, i) =>
        make("option", { value: String(i), textContent: one.name || `column ${i + 1}`, selected: i === meant }),
      ),
    );
    const unit = make(
      "select",
      { ariaLabel: `unit of ${key}` },
      ...["", ...units].map((word) => make("option", { value: word, textContent: word })),
    );
    choices.set(key, { column, unit });
    show_unit({ column, unit });
    for (const select of [column, unit])
      select.onchange = () => {
        show_unit({ column, unit });
        judge();
      };
    return make(
      "tr",
      {},
      make("th", { scope: "row", textContent: key.replaceAll("_", " ") }),
      make("td", {}, column),
      make("td", {}, unit),
    );
  };
  byId("columns_required").replaceChildren(...first.keys.filter((one) => one.required).map(row));
  byId("columns_more").replaceChildren(...first.keys.filter((one) => !one.required).map(row));
  byId("columns_file").textContent = `${name}: columns separated by ${first.separator}`;
  byId("columns_rows").replaceChildren(
    make(
      "thead",
      {},
      make(
        "tr",
        {},
        ...first.columns.map((one, i) => make("th", { scope: "col", textContent: one.name || `column ${i + 1}` })),
      ),
    ),
    make(
      "tbody",
      {},
      ...first.rows.map((fields) => make("tr", {}, ...fields.map((field) => make("td", { textContent: field })))),
    ),
  );
  if (first.refusal) show_judgement(asked, first);
  else await judge();
  dialog.returnValue = "";
  dialog.showModal();
  dialog.querySelector("select").focus();
  return new Promise((done) => {
    dialog.onclose = () => done(dialog.returnValue === "take" ? map() : null);
  });
};
byId("columns_form").onsubmit = (event) => {
  event.preventDefault();
  byId("columns").close("take");
};
byId("columns_cancel").onclick = () => byId("columns").close();

// Recording options as words; the value of --columns in them; the same with another value.
const words_of = (text) =>
  (text.match(/'[^']*'|"[^"]*"|\S+/g) || []).map((word) => word.replace(/^(['"])(.*)\1$/, "$2"));
const columns_in = (words) => (words.includes("--columns") ? words[words.indexOf("--columns") + 1] || "" : "");
const with_columns = (words, map) => {
  const others = words.filter((word, i) => word !== "--columns" && words[i - 1] !== "--columns");
  return map === "" ? others : [...others, "--columns", map];
};
