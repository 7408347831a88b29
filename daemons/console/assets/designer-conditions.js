// SPDX-License-Identifier: Apache-2.0
// Conditions in conjunctive normal form: said in words, and changed literal by literal.
import {el} from "./dom.js";
import {isScalar, list, text} from "./designer-model.js";

export const states = ["scheduled", "running", "aborting", "aborted", "ended", "over"];

function literalText(literal) {
  const not = text(literal?.not) === "true" ? "not " : "";
  const optional = text(literal?.modality) === "optional" ? " (optional)" : "";
  const effect = literal?.effect ? ` → ${text(literal.effect)}` : "";
  if (literal && "componel" in literal) return `${not}${text(literal.componel)} ${text(literal.state)}${optional}${effect}`;
  if (literal && "message" in literal) return `${not}“${text(literal.message)}”${optional}${effect}`;
  if (literal && "time" in literal) return `${not}${text(literal.time)}${isNaN(text(literal.time)) ? "" : " s"} since ${text(literal.since) || "epoch"} ${text(literal.is)}${optional}${effect}`;
  return "?";
}

export const formulaText = (formula) => list(formula).map((clause) => {
  const words = list(clause).map(literalText).join(" or ");
  return list(clause).length > 1 && list(formula).length > 1 ? `(${words})` : words;
}).join(" and ");

const choose = (value, options, onchange) => el("select", {onchange: (event) => onchange(event.target.value)},
  ...[...new Set([...options, value])].filter((one) => one !== undefined && one !== "").map((option) => el("option", {value: option, selected: option === value}, option)));
const quoted = (value) => (/^[A-Za-z][\w *()-]*$/.test(value) ? value : {'"': value});

/** `ids`: of componels that may be named; `messages`: that are usual; `change(formula)` is told the whole of it. */
export function editor(formula, {isExit, isLoop, ids, messages, change, name}) {
  const clauses = list(formula).map((clause) => list(clause));
  const copy = () => clauses.map((clause) => clause.map((literal) => ({...literal})));
  const withLiteral = (i, k, literal) => { const next = copy(); next[i][k] = literal; change(next); };
  const without = (i, k) => { const next = copy(); next[i].splice(k, 1); change(next.filter((clause) => clause.length)); };
  const fresh = () => ({message: "interruption"});

  const literalRow = (literal, i, k) => {
    const kind = ["componel", "message", "time"].find((one) => literal && one in literal) ?? "message";
    const to = (parts) => {
      const next = {...literal, ...parts};
      for (const [key, value] of Object.entries(next)) if (value === undefined) delete next[key];
      withLiteral(i, k, next);
    };
    const become = (other) => withLiteral(i, k, other === "componel" ? {componel: ids[0] ?? "", state: "ended"} : other === "message" ? fresh() : {time: "60", since: "start", is: "passed"});
    const not = text(literal?.not) === "true";
    return el("div", {className: "literal"},
      choose(kind, ["componel", "message", "time"], become),
      el("button", {type: "button", title: "true when it is not so", "aria-pressed": String(not), onclick: () => to({not: not ? undefined : "true"})}, "not"),
      kind === "componel" && choose(text(literal.componel), ids, (value) => to({componel: value})),
      kind === "componel" && choose(text(literal.state), states, (value) => to({state: value})),
      kind === "message" && el("input", {value: text(literal.message), size: 14, "aria-label": "message", list: "messages", onchange: (event) => to({message: quoted(event.target.value)})}),
      kind === "time" && el("input", {value: text(literal.time), size: 8, "aria-label": "seconds, or a parameter of type Time", onchange: (event) => to({time: event.target.value})}),
      kind === "time" && el("input", {value: text(literal.since) || "epoch", size: 9, "aria-label": "since", onchange: (event) => to({since: quoted(event.target.value)})}),
      kind === "time" && choose(text(literal.is), ["passed", "not-yet-passed"], (value) => to({is: value})),
      isExit && isLoop && choose(text(literal.effect) || "exit", ["exit", "continue"], (value) => to({effect: value === "exit" ? undefined : value})),
      choose(text(literal.modality) || "mandatory", ["mandatory", "optional"], (value) => to({modality: value === "mandatory" ? undefined : value})),
      el("button", {type: "button", title: "remove", onclick: () => without(i, k)}, "×"));
  };

  const node = el("div", {className: "conditions", "data-formula": name},
    el("datalist", {id: "messages"}, ...messages.map((one) => el("option", {value: one}))),
    ...clauses.map((clause, i) => el("div", {className: "clause"}, ...clause.map((literal, k) => literalRow(literal, i, k)),
      el("button", {type: "button", className: "or", onclick: () => { const next = copy(); next[i].push(fresh()); change(next); }}, "or…"))),
    el("button", {type: "button", className: "and", onclick: () => change([...copy(), [fresh()]])}, clauses.length ? "and…" : "add a condition"));
  return isScalar(formula) && formula ? el("div", {}, "no formula: edit the text") : node;
}
