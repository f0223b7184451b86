-- The document as the stage cast left it; null for scenes recorded before there was one.
ALTER TABLE scenes ADD COLUMN esg_cast VARCHAR;
