// SPDX-License-Identifier: BSD-3-Clause
import { mount } from "svelte";
import App from "./App.svelte";
import { recording } from "./feed/recording";
import Wall from "./wall/Wall.svelte";

/** `/?wall` is the page for a beamer; a recording is shown with what plays it. */
const page = recording === undefined && new URLSearchParams(location.search).has("wall") ? Wall : App;

mount(page, { target: document.getElementById("page")! });
document.getElementById("starting")?.remove();
