import type { OccupancyGrid } from "../feed/messages";

type Colour = readonly [red: number, green: number, blue: number];

const LIGHT = { free: [255, 255, 255] as Colour, occupied: [70, 74, 80] as Colour };
const DARK = { free: [38, 42, 48] as Colour, occupied: [168, 174, 182] as Colour };

/** The grid as a picture, north up: free to occupied between two greys, unknown transparent. */
export function gridImage({ info, data }: OccupancyGrid, dark: boolean): string {
  const canvas = document.createElement("canvas");
  canvas.width = info.width;
  canvas.height = info.height;
  const context = canvas.getContext("2d");
  if (!context || info.width === 0 || info.height === 0) return "";
  const image = context.createImageData(info.width, info.height);
  const { free, occupied } = dark ? DARK : LIGHT;
  for (let row = 0; row < info.height; row += 1) {
    for (let column = 0; column < info.width; column += 1) {
      const value = data[(info.height - 1 - row) * info.width + column]!;
      if (value < 0) continue;
      const at = (row * info.width + column) * 4;
      for (let part = 0; part < 3; part += 1)
        image.data[at + part] = free[part]! + ((occupied[part]! - free[part]!) * value) / 100;
      image.data[at + 3] = 255;
    }
  }
  context.putImageData(image, 0, 0);
  return canvas.toDataURL();
}
