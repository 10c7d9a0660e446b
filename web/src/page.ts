// SPDX-License-Identifier: BSD-3-Clause
import { mount } from "svelte";
import App from "./App.svelte";
import Wall from "./wall/Wall.svelte";

/** `/?wall` is the page for a beamer, of the live team or of a recording. */
const page = new URLSearchParams(location.search).has("wall") ? Wall : App;

mount(page, { target: document.getElementById("page")! });
document.getElementById("starting")?.remove();
