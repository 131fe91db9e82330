// Plays the motions of the report.

import { Player } from "./player";

addEventListener("DOMContentLoaded", () => {
  const players = [...document.querySelectorAll<HTMLElement>("figure.play")].map(box => new Player(box));
  if (location.hash === "#selfcheck") document.documentElement.dataset.played = String(players.filter(p => p.exercise()).length);
});
