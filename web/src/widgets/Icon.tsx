// The page's icons, by what they stand for. They say nothing to screen readers: the button around them has the name.

import {
  Axis3d,
  Box,
  Camera,
  Check,
  ChevronDown,
  CircleQuestionMark,
  CloudOff,
  Columns2,
  Download,
  Eye,
  FilePlus,
  FlipHorizontal2,
  Grid3x3,
  GripVertical,
  House,
  LayoutGrid,
  type LucideIcon,
  MapPinned,
  Maximize,
  Minimize,
  Moon,
  MoveDiagonal2,
  Pencil,
  Plus,
  Presentation,
  Redo2,
  RotateCcw,
  Rows2,
  Search,
  Share,
  Slice,
  SlidersHorizontal,
  Spline,
  Sun,
  Trash2,
  TriangleAlert,
  Undo2,
  Workflow,
  X,
} from "lucide-react";
import type { ReactElement } from "react";

const ICONS = {
  add: Plus,
  alert: TriangleAlert,
  axes: Axis3d,
  below: Rows2,
  beside: Columns2,
  camera: Camera,
  check: Check,
  close: X,
  control: Spline,
  corner: MoveDiagonal2,
  download: Download,
  eye: Eye,
  file: FilePlus,
  flip: FlipHorizontal2,
  frame: Maximize,
  gallery: LayoutGrid,
  grid: Grid3x3,
  grip: GripVertical,
  help: CircleQuestionMark,
  home: House,
  keep: MapPinned,
  layout: Workflow,
  leave: Minimize,
  moon: Moon,
  offline: CloudOff,
  open: ChevronDown,
  pencil: Pencil,
  perspective: Box,
  redo: Redo2,
  reset: RotateCcw,
  search: Search,
  section: Slice,
  share: Share,
  show: Presentation,
  sliders: SlidersHorizontal,
  sun: Sun,
  trash: Trash2,
  undo: Undo2,
} as const satisfies Record<string, LucideIcon>;

export type IconName = keyof typeof ICONS;

const SIZE = 16;
/** In the icon's own units, 24 to its size: 1.5 pixels. */
const STROKE = 2.25;

export function Icon({ name }: { name: IconName }): ReactElement {
  const Drawing = ICONS[name];
  return <Drawing className="icon" size={SIZE} strokeWidth={STROKE} aria-hidden focusable={false} />;
}
