/* Catalogue of all texts of the page, one section per module, with sorted keys.
   A second language is another module with the same keys, whose address is entered in LANGUAGES. */

/* Addresses of the catalogues of other languages, by language: {de: "./strings.de.js"}. Each exports CATALOGUE. */
export const LANGUAGES = {};

export const CATALOGUE = {
  compare: {
    absent: "none",
    back: "Back to A",
    changes: "Differences from A",
    drop: "Forget A",
    keep: "Keep as A",
    kept: "The present curves are kept as A and are dashed from now on.",
    no_changes: "No field differs from A.",
    row: "{address}: A {before}, now {after}",
  },

  curves: {
    choice: "Choose",
    choice_auto: "Curves of the selected parts",
    clock: "time of the values in the drawing",
    cursor: "{time} s",
    empty: "Curves appear here when the circuit is complete.",
    head_time: "time [s]",
    measured: "{name} (measured)",
    name: "Curves",
    notes: "Notes",
    pause: "Pause",
    play: "Play",
    plot: "{quantity} versus time: {names}",
    short: "first {until} s; the whole run follows",
    speed: "Speed",
    speed_real: "real time",
    speed_whole: "run in 8 s",
    stale: "The curves are those of the last complete circuit.",
    status_done: "{duration} s simulated in {milliseconds} ms.",
    status_other: "The run ended at {time} s: {status}.",
    status_stopped: "A stop condition ended the run at {time} s.",
    summary: "Simulated. {values}",
    summary_value: "{name} ends at {value} {unit}",
    table: "Table of values",
    table_caption: "Values of the curves at selected times",
  },

  drawing: {
    added: "{name} is added and selected.",
    ambient: "the atmosphere",
    atmosphere: "Atmosphere",
    begun: "Connection of {port}: choose a port or a part.",
    cancel: "Cancel",
    cancelled: "No connection.",
    close: "Close",
    connected: "{port} is connected to {target}.",
    copied: "Copied: {names}.",
    driven: "driven by a signal",
    inserted_chamber: "The chamber {name} is inserted between the two ports.",
    inserted_mass: "The mass {name} is inserted between the two actuators.",
    inserted_tube: "The tube {name} is inserted between the two ports.",
    joined: "connected to {target}",
    label: "Drawing of the circuit, {count} parts. Tab goes from part to part. Enter selects a part, then Tab goes to its ports.",
    no_bodies: "Two bodies are not connected to each other. Add an actuator or a joint.",
    no_body: "A rod is connected to a body, such as a mass, joint or guide.",
    no_body_here: "This part has no free connection for a body.",
    no_gas: "Gas ports are connected to gas ports, chambers and reservoirs only.",
    no_gas_here: "This part has no free port for gas.",
    no_inputs: "An input is connected to an output. This is an input as well.",
    no_itself: "An end is not connected to itself.",
    no_output: "An output is connected to an input.",
    no_outputs: "This part has no outputs for an input.",
    no_signal: "A signal is connected to an input.",
    no_signal_here: "This part has no free end for a signal.",
    no_stores: "Gas flows between two gas nodes through a part, such as an orifice or a tube. Add one between them.",
    no_twice: "The two ports are connected already.",
    no_wire: "This wire has no gas node.",
    node_title: "Connect {name}",
    nothing_to_paste: "The clipboard contains no parts. Copy parts first.",
    open: "not connected",
    open_required: "not connected, but necessary",
    part: "{name}, {kind}",
    part_error: "{name}, {kind}. {errors}",
    pasted: "Pasted: {names}.",
    port: "{port}, {type}, {joined}.",
    removed: "Removed: {names}.",
    role: "circuit drawing",
    source: "Source of {input}",
    take_back: "Take it back",
    targets: "All possible ends",
    tube: "Tube instead",
    type_body: "rod",
    type_input: "input",
    type_output: "output",
    type_port: "port",
    type_store: "gas node",
    type_tube: "end of a tube",
  },

  form: {
    connect: "connect to ...",
    connect_optional: "not connected",
    connected: "Connected",
    default: "default {value}",
    driven_by: "driven by",
    driver_of: "Output that drives {name}",
    group_optional: "(optional)",
    inputs: "Inputs",
    itself: "{name} cannot be connected to itself.",
    link_help: "output of another part [{unit}]",
    model_search: "search by catalogue number",
    model_sets: "Sets {values}. {source}.",
    name: "Name",
    needed: "required",
    no_conversion: "A value in {unit} cannot be converted here. Enter the number in the other unit.",
    no_kind: "unknown kind",
    no_part: "No part of this circuit has the name {name}.",
    no_unit: "no unit",
    none: "Select a part to see its properties.",
    not_connected: "no output",
    not_valid: "The text is not valid. Lists are written [1, 2], tables {\"name\": 1}.",
    optional: "optional",
    ports: "Ports",
    required: "required",
    several: "{count} parts are selected: {names}.",
    size: "Size stated by",
    size_of_model: "model",
    slider_of: "Slider of {name}",
    source: "source",
    source_assumed: "assumed",
    source_datasheet: "datasheet",
    source_fitted: "fitted",
    source_given: "given",
    source_locator: "location",
    source_measured: "measured",
    source_note: "note",
    source_of: "Source of {name}: {source}",
    source_paper: "paper",
    source_standard: "standard",
    title: "Properties of {part}",
    unit_of: "Unit of {name}",
    unknown: "This kind of part has no such field.",
  },

  help: {
    close: "Close",
    connect: "Click a port, then another port or a part. Drag does the same. With keys: Enter at a port, Tab or arrow keys to the other one, Enter.",
    escape: "leave a field, a wire, the selection",
    keys: "Keys",
    move: "move the selection by 1 or by 4",
    name: "Help",
    numbers: "Select a part to see its numbers. Enter applies a number. A slider changes the curves while you drag.",
    pan: "Drag the background with the right mouse button, or with two fingers. The wheel with Ctrl zooms.",
    play: "play the run in the drawing",
    search: "search in the palette",
    select: "select all, copy, cut, paste",
    undo: "undo, redo",
    zoom: "zoom, show all",
  },

  measured: {
    column: "measures",
    gone: "Remove {name}",
    invalid: "{file} is not a table of numbers: {problem}",
    name: "Measured curves",
    no_time: "{file}: its first column has the unit {unit}, which is not a unit of time.",
    none: "not compared",
    open: "Add CSV",
    rms: "RMS {value} {unit}",
    rms_kept: "RMS {value} {unit}, A {kept} {unit}",
    rows: "fewer than two rows",
    unit: "Unit of {name}",
  },

  page: {
    applied_again: "The circuit was changed elsewhere. Your change was applied to it.",
    drawing: "Drawing of the circuit",
    form: "Properties",
    not_applied: "The circuit was changed elsewhere, and is displayed as it is now. Your change does not apply to it.",
    palette: "Parts",
    panel_curves: "Curves",
    panel_drawing: "Drawing",
    panel_palette: "Parts",
    panel_side: "Details",
    panels: "Panels",
    run: "Circuit",
    side: "Details",
    skip: "Skip to the drawing",
    tasks: "Tasks",
    text: "Text",
    title: "{name} - poppet edit",
    title_dirty: "* {name} - poppet edit",
    unnamed: "new circuit",
  },

  palette: {
    add: "Add {kind}: {summary}",
    group_actuators: "Actuators",
    group_bodies: "Bodies",
    group_control: "Control",
    group_flow: "Flow",
    group_logic: "Logic",
    group_other: "Other",
    group_supply: "Supply",
    group_vacuum: "Vacuum",
    group_valves: "Valves",
    group_volumes: "Volumes",
    nothing: "No part has this name.",
    search: "Search parts",
  },

  problems: {
    crashed: "The simulation ended unexpectedly. It starts again with the next change.",
    disk: "{name} was changed on disk.",
    disk_keep: "Keep mine",
    disk_take: "Use the text of the file",
    ended: "The session of this page is over. Open the address that the terminal shows. The circuit is still here: copy its text.",
    hangs: "The simulation took more than {seconds} s and was ended. Change a number, or shorten the run.",
    lost: "The server does not answer. The circuit is still here: copy its text, or start the server again.",
    name: "Errors",
    overwrite: "{name} was changed on disk after it was opened. Writing replaces those changes.",
    overwrite_yes: "Replace the file",
    refused: "Not possible: {message}",
    retry: "Try again",
    saved: "{name} is saved.",
    title: "{count} errors keep the circuit from running",
    title_one: "One error keeps the circuit from running",
  },

  quantities: {
    "1": "Signals",
    "K": "Temperature",
    "N": "Force",
    "N m": "Torque",
    "Pa": "Pressure",
    "W": "Power",
    "kg": "Mass",
    "kg/s": "Mass flow",
    "m": "Position",
    "m/s": "Velocity",
    "m/s^2": "Acceleration",
    "m^2": "Area",
    "m^3": "Volume",
    "rad": "Angle",
    "rad/s": "Angular velocity",
    "rad/s^2": "Angular acceleration",
  },

  run: {},

  save: {
    cancel: "Cancel",
    file: "File name in {folder}",
    name: "Name of the file",
    write: "Write",
  },

  signals: {},

  start: {
    again: "{title}, {date}",
    back: "Back",
    discard: "The circuit has changes that are not in its file. They are lost if you open another one.",
    discard_yes: "Open without them",
    empty: "Empty circuit",
    files: "Files of the folder",
    lead: "Click parts in the palette, or begin with a template.",
    name: "Start",
    no_files: "The folder has no circuit files.",
    templates: "Templates",
  },

  tasks: {},

  text: {},

  toolbar: {
    copied: "The text is in the clipboard.",
    copy_text: "Copy the text",
    delete: "Delete",
    delete_keys: "Delete the selection (Del)",
    file: "File",
    fit: "Fit",
    fit_keys: "Show the whole circuit (0)",
    help: "Help",
    help_keys: "Keys and hints (?)",
    mirror: "Mirror",
    mirror_keys: "Mirror the selection (M)",
    name: "Tools",
    open: "Open or new ...",
    redo: "Redo",
    redo_keys: "Redo (Ctrl+Y)",
    rotate: "Rotate",
    rotate_keys: "Rotate the selection by 90° (R)",
    save: "Save",
    save_as: "Write to another file ...",
    save_keys: "Save (Ctrl+S)",
    undo: "Undo",
    undo_keys: "Undo (Ctrl+Z)",
    zoom_in: "Zoom in",
    zoom_out: "Zoom out",
  },
};

let language = {};

/* Return the text of a key `section.name`, with the values of its places such as {name}. */
export function text(key, places = {}) {
  const [section, name] = key.split(/\.(.*)/s);
  const phrase = language[section]?.[name] ?? CATALOGUE[section]?.[name] ?? key;
  return phrase.replace(/\{(\w+)\}/g, (place, field) => (field in places ? String(places[field]) : place));
}

/* Load the catalogue of the first language of a list that has one; English needs none. */
export async function loadLanguage(languages) {
  for (const name of languages.map(tag => tag.slice(0, 2).toLowerCase())) {
    if (name === "en") return "en";
    if (name in LANGUAGES) {
      language = (await import(LANGUAGES[name])).CATALOGUE;
      return name;
    }
  }
  return "en";
}

/* Fill the texts, names and tooltips of the elements below an element. */
export function fillTexts(root) {
  for (const element of root.querySelectorAll("[data-text]")) element.textContent = text(element.dataset.text);
  for (const element of root.querySelectorAll("[data-label]")) element.setAttribute("aria-label", text(element.dataset.label));
  for (const element of root.querySelectorAll("[data-title]")) element.title = text(element.dataset.title);
}
