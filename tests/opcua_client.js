// OPC UA client of node-opcua: browses all variables, reads them, and writes values.
// Arguments: URL, JSON list of [node, data type, value]. Prints one JSON object.
const {
  AttributeIds, DataType, OPCUAClient, BrowseDirection, NodeClass, MessageSecurityMode, SecurityPolicy,
} = require("node-opcua-client");

async function variablesBelow(session, nodeId, found) {
  const result = await session.browse({
    nodeId, browseDirection: BrowseDirection.Forward, referenceTypeId: "HierarchicalReferences", includeSubtypes: true,
    resultMask: 63,
  });
  for (const reference of result.references) {
    if (reference.nodeClass === NodeClass.Variable) found.push(reference.nodeId.toString());
    await variablesBelow(session, reference.nodeId, found);
  }
  return found;
}

function plain(value) {
  if (typeof value === "bigint") return Number(value);
  if (Array.isArray(value)) return value.map(plain);
  if (value === null || typeof value !== "object") return Number.isNaN(value) ? "nan" : value;
  if ("text" in value) return value.text;
  if ("unitId" in value) return { unit: value.displayName.text, code: value.unitId };
  if ("low" in value) return [String(value.low), String(value.high)];
  if ("displayName" in value) return value.displayName.text;
  return String(value);
}

async function main(url, writes) {
  const client = OPCUAClient.create({
    endpointMustExist: false, securityMode: MessageSecurityMode.None, securityPolicy: SecurityPolicy.None,
    connectionStrategy: { maxRetry: 1 },
  });
  await client.connect(url);
  const session = await client.createSession();
  const nodes = await variablesBelow(session, "ns=2;s=$machine", []);
  const values = await session.read(nodes.map((nodeId) => ({ nodeId, attributeId: AttributeIds.Value })));
  const read = {};
  nodes.forEach((nodeId, k) => {
    const value = values[k];
    read[nodeId] = { status: value.statusCode.name, type: DataType[value.value.dataType], value: plain(value.value.value),
      time: value.sourceTimestamp };
  });
  const codes = await session.write(writes.map(([nodeId, type, value]) => ({
    nodeId, attributeId: AttributeIds.Value, value: { value: { dataType: DataType[type], value } },
  })));
  await session.close();
  await client.disconnect();
  console.log(JSON.stringify({ read, written: codes.map((code) => code.name) }));
  process.exit(0);
}

main(process.argv[2], JSON.parse(process.argv[3])).catch((error) => {
  console.error(error);
  process.exit(1);
});
