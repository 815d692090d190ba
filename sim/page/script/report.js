// What runs when a page is opened. Without it the page says the same, in tables.
import { drawCharts } from "#charts";
import { addParallels } from "#parallel";
import { startPoints } from "#points";
import { startProbe } from "#probe";
import { addScatters } from "#scatter";
import { enrichTables } from "#tables";

enrichTables(document);
startProbe(document);
drawCharts(document, window);
addScatters(document, window);
addParallels(document, window);
startPoints(document);
