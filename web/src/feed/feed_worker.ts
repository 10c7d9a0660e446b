// SPDX-License-Identifier: BSD-3-Clause
// The thread in which the feed runs.
import { ownTasks } from "../lib/tasks";
import { FeedServer, type Order } from "./feed_server";

const server = new FeedServer((report, transfer = []) => postMessage(report, { transfer }), ownTasks());
onmessage = ({ data }: MessageEvent<Order>) => server.obey(data);
