# SPDX-License-Identifier: GPL-3.0-or-later
"""Every Pset_* and Qto_* of an IFC file must be one of the standard's, with the standard's properties and kinds of values,
on an element that it is meant for: check_property_templates.py FILE"""
import sys

import ifcopenshell
import ifcopenshell.util.pset

KINDS = {
    "IfcPropertySingleValue": "P_SINGLEVALUE",
    "IfcPropertyEnumeratedValue": "P_ENUMERATEDVALUE",
    "IfcQuantityLength": "Q_LENGTH",
    "IfcQuantityArea": "Q_AREA",
    "IfcQuantityVolume": "Q_VOLUME",
}


def faults(model):
    templates = ifcopenshell.util.pset.get_template(model.schema_identifier)
    checked = 0
    for relation in model.by_type("IfcRelDefinesByProperties"):
        definition = relation.RelatingPropertyDefinition
        if not definition.Name.startswith(("Pset_", "Qto_")):
            continue
        template = templates.get_by_name(definition.Name)
        if template is None:
            yield f"{definition.Name} is not in the standard"
            continue
        known = {t.Name: t for t in template.HasPropertyTemplates}
        for item in getattr(definition, "HasProperties", None) or definition.Quantities:
            checked += 1
            where = f"{definition.Name}.{item.Name}"
            if item.Name not in known:
                yield f"{where} is not in the standard"
            elif KINDS[item.is_a()] != known[item.Name].TemplateType:
                yield f"{where} is {item.is_a()}, not {known[item.Name].TemplateType}"
            elif item.is_a("IfcPropertySingleValue") and item.NominalValue.is_a() != known[item.Name].PrimaryMeasureType:
                yield f"{where} is {item.NominalValue.is_a()}, not {known[item.Name].PrimaryMeasureType}"
        for element in relation.RelatedObjects:
            names = templates.get_applicable_names(element.is_a(), qto_only=definition.Name.startswith("Qto_"))
            if definition.Name not in names:
                yield f"{definition.Name} is not meant for {element.is_a()}"
    if checked == 0:
        yield "the file has no standard properties"


def main():
    found = sorted(set(faults(ifcopenshell.open(sys.argv[1]))))
    print("\n".join(found) or "all as in the standard")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
